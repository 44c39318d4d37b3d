#include "app/interrupt.h"

#include <csignal>

namespace viewcover {
namespace {

static_assert(std::atomic<bool>::is_always_lock_free &&
              std::atomic<std::atomic<bool>*>::is_always_lock_free);
std::atomic<bool> interrupted = false;
std::atomic<std::atomic<bool>*> forward_to = nullptr;

void on_interrupt(int) { interrupt(); }

}  // namespace

void install_signal_handlers() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
}

const std::atomic<bool>& interrupt_flag() { return interrupted; }

void interrupt() {
  interrupted = true;
  if (std::atomic<bool>* const target = forward_to) *target = true;
}

ForwardInterrupt::ForwardInterrupt(std::atomic<bool>& target) {
  forward_to = &target;
  if (interrupted) target = true;
}

ForwardInterrupt::~ForwardInterrupt() { forward_to = nullptr; }

}  // namespace viewcover
