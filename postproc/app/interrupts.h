// SPDX-License-Identifier: GPL-2.0-or-later
// What ends the program from outside.
#pragma once

namespace mikromakro {

/// From now on a signal that ends the program leaves no temporary file of an output behind, a file that may
/// not grow any further (ulimit -f) is an error of writing and no signal, and files that are opened never get
/// the number of a standard stream that the caller has closed.
void prepare_for_interrupts();

}  // namespace mikromakro
