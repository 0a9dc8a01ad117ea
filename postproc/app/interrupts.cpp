// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/interrupts.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>

#include "io/files/output_file.h"

namespace mikromakro {
namespace {

// The signal's own action comes back when its handler begins (SA_RESETHAND), so that the second one ends the
// program as if the first had never been caught: the shell sees 128 + its number.
void clean_up(int number) {
  remove_unfinished_outputs();
  raise(number);
}

void catch_signal(int number) {
  struct sigaction before = {};
  sigaction(number, nullptr, &before);
  if (before.sa_handler == SIG_IGN) return;  // as nohup wants it
  struct sigaction after = {};
  after.sa_handler = clean_up;
  after.sa_flags = SA_RESETHAND;
  sigaction(number, &after, nullptr);
}

}  // namespace

void prepare_for_interrupts() {
  // Opened the wrong way round, so that reading and writing fail there as if it were closed.
  if (fcntl(STDIN_FILENO, F_GETFD) == -1) open("/dev/null", O_WRONLY);
  if (fcntl(STDOUT_FILENO, F_GETFD) == -1) open("/dev/null", O_RDONLY);
  if (fcntl(STDERR_FILENO, F_GETFD) == -1) open("/dev/null", O_WRONLY);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU}) catch_signal(number);
  signal(SIGXFSZ, SIG_IGN);
}

}  // namespace mikromakro
