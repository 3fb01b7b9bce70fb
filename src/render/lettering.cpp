#include "render/lettering.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/vector.hpp"

namespace surpass::picture {
namespace {

// Lines through places of a grid, two digits a place (right, up); blanks lift the pen. The base
// line is at 2, small letters reach 6, tall ones and digits 8.
constexpr std::string_view strokes_of(char c) {
  switch (c) {
    case '0': return "123243473818070312";
    case '1': return "172822 1232";
    case '2': return "07183847460242";
    case '3': return "07183847463525 354443321203";
    case '4': return "32380444";
    case '5': return "480805354443321203";
    case '6': return "473818070312324344351504";
    case '7': return "084812";
    case '8': return "15060718384746351504031232434435";
    case '9': return "031232434738180706153546";
    case '-': return "0535";
    case '+': return "0545 2327";
    case '.': return "0202";
    case '/': return "0138";
    case 'a': return "3616050312223336 3632";
    case 'b': return "0802 0516263533221203";
    case 'c': return "3526160503122233";
    case 'd': return "3832 3526160503122233";
    case 'e': return "043435261605031232";
    case 'f': return "38281712 0636";
    case 'g': return "3526160503122233 3631201001";
    case 'h': return "0802 0516263532";
    case 'i': return "0602 0808";
    case 'j': return "161100 1818";
    case 'k': return "0802 3604 0432";
    case 'l': return "0802";
    case 'm': return "0602 0516263532 3546566562";
    case 'n': return "0602 0516263532";
    case 'o': return "122233352616050312";
    case 'p': return "0600 0516263533221203";
    case 'q': return "3630 3526160503122233";
    case 'r': return "0602 05162636";
    case 's': return "3616051424332202";
    case 't': return "18132232 0636";
    case 'u': return "0603122233 3632";
    case 'v': return "062246";
    case 'w': return "0612365266";
    case 'x': return "0632 0236";
    case 'y': return "0622 461000";
    case 'z': return "06360232";
    default: return "";
  }
}

constexpr float kGrid = 6;  // from the base line to the top
constexpr float kBase = 2;
constexpr float kGap = 1.7F;  // between letters, in steps of the grid
constexpr float kBlank = 2.5F;
constexpr float kPenWidth = 0.13F;  // of the height
constexpr float kInk = 40;          // sRGB

// Calls visit(right, up, pen_down) for the places of a letter's lines in their order.
template <class Visit>
void for_each_place(char c, const Visit& visit) {
  const std::string_view strokes = strokes_of(c);
  bool pen_down = false;
  for (std::size_t i = 0; i < strokes.size();) {
    if (strokes[i] == ' ') {
      pen_down = false;
      ++i;
      continue;
    }
    visit(static_cast<float>(strokes[i] - '0'), static_cast<float>(strokes[i + 1] - '0'), pen_down);
    pen_down = true;
    i += 2;
  }
}

float advance(char c) {
  if (strokes_of(c).empty()) return kBlank;
  float widest = 0;
  for_each_place(c, [&](float right, float, bool) { widest = std::max(widest, right); });
  return widest + kGap;
}

struct Segment {
  Vec2 a, b;
};

std::vector<Segment> segments_of(std::string_view text, float x, float y, float height) {
  const float step = height / kGrid;
  std::vector<Segment> segments;
  for (const char c : text) {
    Vec2 before = Vec2::Zero();
    for_each_place(c, [&](float right, float up, bool pen_down) {
      const Vec2 place(x + step * right, y - step * (up - kBase));
      if (pen_down) segments.push_back({before, place});
      before = place;
    });
    x += step * advance(c);
  }
  return segments;
}

float distance(const Vec2& p, const Segment& s) {
  const Vec2 along = s.b - s.a;
  const float length2 = along.squaredNorm();
  const float t = length2 > 0 ? std::clamp((p - s.a).dot(along) / length2, 0.0F, 1.0F) : 0.0F;
  return (s.a + t * along - p).norm();
}

void darken(Image& image, int x, int y, float ink) {
  const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                  static_cast<std::size_t>(x);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto paper = static_cast<float>(image.pixels[3 * at + k]);
    image.pixels[3 * at + k] = static_cast<std::uint8_t>(std::lround(paper + ink * (kInk - paper)));
  }
}

}  // namespace

float text_width(std::string_view text, float height) {
  float width = 0;
  for (const char c : text) width += advance(c);
  return std::max(0.0F, width - kGap) * height / kGrid;
}

void write_text(Image& image, std::string_view text, float x, float y, float height) {
  constexpr int kReach = 2;  // of the pen beyond its places, in pixels
  const float half = std::max(0.55F, kPenWidth * height / 2);
  const std::vector<Segment> segments = segments_of(text, x, y, height);
  const float end = x + text_width(text, height);
  const int left = std::max(0, static_cast<int>(x) - kReach);
  const int right = std::min(image.width, static_cast<int>(end) + 2 * kReach);
  const int top = std::max(0, static_cast<int>(y - height) - kReach);
  const int bottom = std::min(image.height, static_cast<int>(y + height / 3) + 2 * kReach);
  for (int j = top; j < bottom; ++j) {
    for (int i = left; i < right; ++i) {
      const Vec2 centre(static_cast<float>(i) + 0.5F, static_cast<float>(j) + 0.5F);
      float nearest = half + 1;
      for (const Segment& s : segments) nearest = std::min(nearest, distance(centre, s));
      darken(image, i, j, std::clamp(0.5F + half - nearest, 0.0F, 1.0F));
    }
  }
}

}  // namespace surpass::picture
