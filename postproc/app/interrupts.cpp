// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/interrupts.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>

#include "io/files/output_file.h"

namespace mikromakro {
namespace {

// SA_RESETHAND restores the default action on entry, so re-raising the signal ends the program as if it had
// never been caught: the shell sees 128 + its number.
void clean_up(int number) {
  remove_unfinished_outputs();
  raise(number);
}

void catch_signal(int number) {
  struct sigaction before = {};
  sigaction(number, nullptr, &before);
  if (before.sa_handler == SIG_IGN) return;  // keep a signal ignored, as set by nohup
  struct sigaction after = {};
  after.sa_handler = clean_up;
  after.sa_flags = SA_RESETHAND;
  sigaction(number, &after, nullptr);
}

}  // namespace

void prepare_for_interrupts() {
  // Opened in the wrong direction, so that reading and writing fail as they do on a closed stream.
  if (fcntl(STDIN_FILENO, F_GETFD) == -1) open("/dev/null", O_WRONLY);
  if (fcntl(STDOUT_FILENO, F_GETFD) == -1) open("/dev/null", O_RDONLY);
  if (fcntl(STDERR_FILENO, F_GETFD) == -1) open("/dev/null", O_WRONLY);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU}) catch_signal(number);
  signal(SIGXFSZ, SIG_IGN);
}

}  // namespace mikromakro
