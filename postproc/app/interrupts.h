// SPDX-License-Identifier: GPL-2.0-or-later
// Termination of the program from outside.
#pragma once

namespace mikromakro {

/// Installs handlers so that a terminating signal leaves no temporary output file behind, exceeding the file
/// size limit (ulimit -f) is a write error rather than a signal, and opened files never get the descriptor of
/// a standard stream that the caller has closed.
void prepare_for_interrupts();

}  // namespace mikromakro
