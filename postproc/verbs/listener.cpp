// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/listener.h"

namespace mikromakro {
namespace {

thread_local Listener* current = nullptr;

}  // namespace

Listener::Listener() {
  current = this;
}

Listener::~Listener() {
  current = nullptr;
}

Listener* Listener::of_this_thread() {
  return current;
}

}  // namespace mikromakro
