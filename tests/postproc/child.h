// SPDX-License-Identifier: GPL-2.0-or-later
// What another process does at the same time.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <functional>

#include "model/error.h"

namespace mikromakro {

/// Another process that does `action`; it ends with this object, whatever happens to the test.
class Child {
 public:
  /// The exit code is what the action gives, 1 if it throws.
  explicit Child(const std::function<int()>& action) : id_(fork()) {
    if (id_ != 0) return;
    int code = 1;
    try {
      code = action();
    } catch (const Error& error) {
      std::printf("%s\n", error.what());
      std::fflush(stdout);
    }
    _exit(code);
  }
  ~Child() {
    if (id_ <= 0) return;
    kill(id_, SIGKILL);
    waitpid(id_, nullptr, 0);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// The code of an exit, -1 where a signal came first.
  int exit_code() {
    int status = 0;
    waitpid(id_, &status, 0);
    id_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t id_;
};

}  // namespace mikromakro
