// SPDX-License-Identifier: GPL-2.0-or-later
// The scenes of the tests are written once, in the lines of LIGGGHTS; each engine gets them in its own.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace mikromakro::test {

class EngineLines {
 public:
  /// The line, or those that mean the same to this engine: none where it only told something for later.
  std::vector<std::string> of(const std::string& line);

 private:
  // Constants by the id of the fix that gives them, of the types i, j at (i - 1) * types + j - 1.
  struct Constant {
    std::string keyword;
    int types;
    std::vector<std::string> values;
  };
  std::vector<std::string> coefficients() const;

  std::map<std::string, Constant> constants_;
  bool law_defined_ = false, coefficients_due_ = false;
};

/// All lines of a script.
std::string lines_of_engine(const std::string& script);

}  // namespace mikromakro::test
