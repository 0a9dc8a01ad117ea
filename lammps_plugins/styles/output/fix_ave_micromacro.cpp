// SPDX-License-Identifier: GPL-2.0-or-later
#include "output/fix_ave_micromacro.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "atom.h"
#include "engine/arguments.h"
#include "engine/engine_access.h"
#include "engine/first_rank.h"
#include "group.h"
#include "io/frames/frame_stream.h"
#include "law/disc_law.h"
#include "law/effects_line.h"
#include "mikromakro_version.h"
#include "model/error.h"
#include "model/nearest_name.h"
#include "options/plausible_options.h"
#include "options/value_checks.h"
#include "output/frame_gathering.h"
#include "update.h"

namespace mikromakro::styles {

namespace {

// Maps script keywords to program options: bulk_types is --bulk-types, `file` is --out.
std::string option_name(const std::string& word) {
  if (word == "file") return "--out";
  if (word == "out") return word;
  std::string name = "--" + word;
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

// The unknown word, with the most similar option.
std::string with_guess(const CLI::App& app, const std::string& word) {
  std::vector<std::string> words = {"file"};
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) words.push_back(name);
  for (std::string& name : words) std::replace(name.begin(), name.end(), '-', '_');
  return in_quotes_with_guess(word, std::vector<std::string_view>(words.begin(), words.end()));
}

std::vector<std::string> names_at(const std::vector<std::string>& names, LAMMPS_NS::bigint step) {
  std::vector<std::string> files = names;
  for (std::string& file : files) {
    const std::size_t star = file.find('*');
    if (star != std::string::npos) file.replace(star, 1, std::to_string(step));
  }
  return files;
}

/// Adds the leading dashes to options. A word that is not an option must be a value of the preceding option.
void name_options(const CLI::App& app, std::vector<std::string>& words) {
  std::set<std::string> seen;
  int values = 0;
  for (std::string& word : words) {
    const std::string name = option_name(word);
    const CLI::Option* option = app.get_option_no_throw(name);
    if (!option && values-- <= 0)
      throw bad_input({"options"}, "unknown option", "an option of `mikromakro average`, without dashes",
                      with_guess(app, word));
    if (!option) continue;
    if (name != "--out" && !seen.insert(name).second)
      throw bad_input({"options"}, "an option is given twice", word + " once", "it again");
    values =
        option->get_allow_extra_args() ? option->get_items_expected_max() : option->get_items_expected_min();
    word = name;
  }
}

bool numbered(const std::string& name) {
  return name.find('*') != std::string::npos;
}

}  // namespace

FixAveMicromacro::FixAveMicromacro(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : FixWithClock(engine, narg, arg) {
  Arguments arguments(*engine, style, narg, arg, 3);
  nevery = static_cast<int>(arguments.integer("Nevery", 1, std::numeric_limits<int>::max()));
  write_every_ = arguments.integer("Nfreq", 1, std::numeric_limits<int>::max());
  if (write_every_ % nevery != 0)
    arguments.fail("Nfreq: expected a multiple of Nevery = " + std::to_string(nevery) + ", got " +
                   std::to_string(write_every_));
  std::vector<std::string> words;
  while (arguments.more()) words.push_back(arguments.word("option"));
  try {
    parse(std::move(words));
    averager_ = make_averager(options_);
    check_use(options_.volumes, *averager_);
  } catch (const std::exception& error) {
    arguments.fail(error.what());
  }
  if (options_.out.empty()) arguments.fail("expected 'file NAME'");
  if (std::find(options_.out.begin(), options_.out.end(), "-") != options_.out.end())
    arguments.fail("file: expected a name ending in .csv, .h5, .vtkhdf or .hdf, got '-'");
  const auto windows = std::count_if(options_.out.begin(), options_.out.end(), numbered);
  windows_ = windows > 0;
  if (windows_ && windows < std::ssize(options_.out))
    arguments.fail("file: expected a * in all names or in none, got both");
  averaged_.sums = no_sums(options_, *averager_);
  // Fail before a long run starts.
  on_first_rank(*lmp, style, [this] { const TableOutputs can_be_written(names_at(options_.out, 0)); });
}

void FixAveMicromacro::parse(std::vector<std::string> words) {
  CLI::App app;
  app.set_help_flag();
  add_average_options(app, options_);
  check_values(app);
  name_options(app, words);
  check_lists(app, words);
  // The parser takes its arguments in reverse order.
  std::reverse(words.begin(), words.end());
  try {
    app.parse(words);
  } catch (const CLI::ParseError& error) {
    throw Error(Error::Kind::bad_input,
                complaint(app, error, "an option of `mikromakro average`, without dashes"));
  }
}

int FixAveMicromacro::calls_wanted() const {
  return LAMMPS_NS::FixConst::END_OF_STEP;
}

void FixAveMicromacro::init() {
  notice_new_count();
  if (!active_disc_law(*lmp))
    stop(*lmp, style, std::string("needs '") + disc_pair_style + "' before the run");
  require_orthogonal_box(*lmp, style);
  check_outputs(*lmp, *this);
  for (const int type : options_.volumes.bulk_types)
    if (type > atom->ntypes)
      stop(*lmp, style,
           "bulk_types: expected types from 1 to " + std::to_string(atom->ntypes) + ", got " +
               std::to_string(type));
}

void FixAveMicromacro::setup(int /*vflag*/) {
  warn_of_discs_outside(*lmp, *this);
  warn_of_constants();
  warn_of_change();
  warn_of_height(*lmp, *this, options_.volumes.height);
}

void FixAveMicromacro::warn_of_change() {
  auto constants = active_disc_law(*lmp)->given_constants();
  if (!constants_.empty() && constants_ != constants && averaged_.sums.frames() > 0)
    print_line(
        *lmp,
        "WARNING: fix " + std::string(id) + " (" + style +
            "): constants of the law have changed: the averages also include frames from before the change");
  constants_ = std::move(constants);
}

/// E and G in units of k_n/h use the k_n given to the fix; sliding uses its mu.
void FixAveMicromacro::warn_of_constants() const {
  warn_of("kn", "kn", options_.fields.numbers.normal_stiffness);
  warn_of("coefficientFriction", "mu", options_.fields.numbers.friction_coefficient);
}

void FixAveMicromacro::warn_of(const std::string& name, const std::string& keyword, double given) const {
  constexpr double digits = 1e-6;
  if (given == 0) return;
  for (const MaterialConstant& constant : active_disc_law(*lmp)->given_constants()) {
    if (constant.name != name) continue;
    const bool hertz = constant.unit == "N/m^2";
    for (const double value : constant.values) {
      if (!hertz && std::abs(value - given) <= digits * given) continue;
      std::string text = std::string("fix ") + id + " (" + style + "): " + keyword + " " + text_of(given);
      text += hertz ? " N/m is used, but the law is Hertzian, whose kn is in N/m^2"
                    : " is used, but the law has " + text_of(value) +
                          " (perhaps for some types only): fields that use it are computed with the first";
      warn(*lmp, text);
      return;
    }
  }
}

void FixAveMicromacro::renumber_steps(LAMMPS_NS::bigint /*shift*/) {
  averaged_ = {no_sums(options_, *averager_), {}};
  waiting_ = 0;
}

void FixAveMicromacro::end_of_step() {
  RawFrame raw = gather_frame(*lmp, groupbit, style);
  on_first_rank(*lmp, style, [&] {
    Frame frame;
    join(raw, frame, {});
    look(frame);
    averaged_.add(frame.step, averager_->frame_sums(frame));
    if (update->ntimestep % write_every_ == 0) write();
  });
  ++waiting_;
  if (update->ntimestep % write_every_ != 0) return;
  waiting_ = 0;
  announced_ = false;
}

bool FixAveMicromacro::needs_forces() const {
  return (averager_->contacts_needed() & column_set(ContactColumn::fx)) != 0;
}

/// As the program does (options/plausible_options.h); the height is looked at beside the radii of all types.
void FixAveMicromacro::look(const Frame& frame) {
  VolumeOptions volumes = options_.volumes;
  volumes.height = 0;
  note_volumes(frame, volumes, *notes_);
  note_friction(frame, options_.fields.numbers.friction_coefficient, *notes_);
  note_stiffness(frame, options_.fields.numbers.normal_stiffness, true, *notes_);
  if (needs_forces()) note_branch(frame, options_.volumes, *notes_);
  if (discs_) return;
  const auto solid = make_averager(options_.volumes, make_fields({"solid_fraction"}));
  discs_ = (solid->frame_sums(frame) != 0).any();
}

std::vector<std::string> FixAveMicromacro::warnings() {
  if (!discs_) notes_->add("no disc lies in the volumes, or none is of an averaged type");
  std::vector<std::string> texts = notes_->lines();
  for (std::string& text : texts)
    if (text.starts_with("--")) text.erase(0, 2);
  return texts;
}

/// On the screen once, above each table.
void FixAveMicromacro::tell(Preamble& lines) {
  for (const std::string& text : warnings()) {
    lines.emplace_back("warning", text);
    // Without the number of times, which differs between windows.
    if (told_.insert(text.substr(0, text.rfind(" ("))).second)
      print_line(*lmp, "WARNING: fix " + std::string(id) + " (" + style + "): " + text);
  }
}

void FixAveMicromacro::run_ended() {
  if (waiting_ == 0 || announced_) return;
  announced_ = true;
  const LAMMPS_NS::bigint next = (update->ntimestep / write_every_ + 1) * write_every_;
  print_line(*lmp, "WARNING: fix " + std::string(id) + " (" + style + "): " + std::to_string(waiting_) +
                       " frames are not in any table yet: Nfreq = " + std::to_string(write_every_) +
                       " writes the next one in step " + std::to_string(next));
}

void FixAveMicromacro::write() {
  TableOutputs outputs(names_at(options_.out, update->ntimestep));
  Preamble lines = {
      {"program", "mikromakro " MIKROMAKRO_VERSION " fix ave/micromacro"},
      {"run", std::string("group ") + group->names[igroup] + ", every " + std::to_string(nevery) + " steps"}};
  tell(lines);
  if (needs_forces() && has_engine_walls(*modify))
    lines.emplace_back("warning", std::string("contacts with ") + engine_walls + " are not in the averages");
  write_averages(options_, averaged_table(options_, *averager_, averaged_, std::move(lines)), outputs);
  if (!windows_) return;
  averaged_ = {no_sums(options_, *averager_), {}};
  notes_.emplace();
  discs_ = false;
}

}  // namespace mikromakro::styles
