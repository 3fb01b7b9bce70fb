#include "signals.hpp"

#include <csignal>

#include <unistd.h>

namespace surpass::cli {

namespace {

std::atomic<bool> interrupted = false;
std::atomic<bool> unfinished = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

void on_signal(int /*signal*/) {
  if (interrupted.exchange(true) && !unfinished) _exit(130);
}

}  // namespace

const std::atomic<bool>& catch_signals() {
  struct sigaction action = {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  return interrupted;
}

UnfinishedFile::UnfinishedFile(const std::string& path) { unfinished = path != "-"; }

UnfinishedFile::~UnfinishedFile() { unfinished = false; }

}  // namespace surpass::cli
