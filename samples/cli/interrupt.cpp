#include "interrupt.h"

#include <atomic>
#include <csignal>

namespace cli {

namespace {

// A signal handler can only reach globals; both are lock-free.
std::atomic<bool> interrupted{false};
std::atomic<vbgpd_job*> watched{nullptr};

extern "C" void on_interrupt(int) {
  interrupted = true;
  if (vbgpd_job* job = watched) vbgpd_job_cancel(job);
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace

InterruptGuard::InterruptGuard() { std::signal(SIGINT, on_interrupt); }

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  watched = nullptr;
}

void InterruptGuard::watch(vbgpd_job* job) { watched = job; }

bool InterruptGuard::requested() { return interrupted; }

}  // namespace cli
