#include <surpass/reconstruct.hpp>

namespace surpass {

const char* name_of(Choice choice) {
  switch (choice) {
    case Choice::automatic: return "auto";
    case Choice::on: return "on";
    case Choice::off: return "off";
  }
  return "";
}

const char* name_of(Closing closing) {
  switch (closing) {
    case Closing::all: return "all";
    case Closing::small: return "small";
    case Closing::none: return "none";
  }
  return "";
}

const char* name_of(Positions positions) {
  switch (positions) {
    case Positions::automatic: return "auto";
    case Positions::original: return "original";
    case Positions::smoothed: return "smoothed";
  }
  return "";
}

}  // namespace surpass
