// SPDX-License-Identifier: GPL-2.0-or-later
// A corpus of malformed dumps made from a good pair, read and averaged under the address and
// undefined-behaviour sanitizers: each gives one clear error or a correct result, never a crash, a hang, or a
// silent wrong number.
#include <gtest/gtest.h>

#include <random>

#include "corpus.h"

namespace mikromakro {
namespace {

class Corpus : public testing::Test {
 protected:
  Outcome outcome(const std::string& particles, const std::string& contacts) const {
    FrameSource source;
    source.particle_files = {folder_.write("particles", particles)};
    source.contact_files = {folder_.write("contacts", contacts)};
    return outcome_of(source);
  }

  bool as_good(const Outcome& outcome) const { return outcome.same_as(good_); }

  const Folder folder_;
  const std::string particles_ = read_text(TEST_DATA "/good/particles.dump");
  const std::string contacts_ = read_text(TEST_DATA "/good/contacts.dump");
  const Outcome good_ = outcome(particles_, contacts_);
};

TEST_F(Corpus, TheGoodPairIsRead) {
  EXPECT_EQ(good_.error, "");
  EXPECT_EQ(good_.table.rows.rows(), 3);
}

TEST_F(Corpus, AFileThatEndsTooSoonIsRefusedWhereverItEnds) {
  for (std::size_t length = 0; length < particles_.size(); ++length) {
    EXPECT_TRUE(outcome(particles_.substr(0, length), contacts_).refused())
        << "particles cut after " << length;
  }
  for (std::size_t length = 0; length < contacts_.size(); ++length) {
    EXPECT_TRUE(outcome(particles_, contacts_.substr(0, length)).refused())
        << "contacts cut after " << length;
  }
}

TEST_F(Corpus, EveryLineThatIsMissingOrThereTwiceIsNoticed) {
  const auto particles = lines_of(particles_), contacts = lines_of(contacts_);
  for (std::size_t k = 0; k < particles.size(); ++k) {
    auto without = particles, twice = particles;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(k));
    twice.insert(twice.begin() + static_cast<std::ptrdiff_t>(k), particles[k]);
    EXPECT_TRUE(outcome(joined(without), contacts_).refused()) << "without " << particles[k];
    EXPECT_TRUE(outcome(joined(twice), contacts_).refused()) << "twice " << particles[k];
  }
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    auto without = contacts, twice = contacts;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(k));
    twice.insert(twice.begin() + static_cast<std::ptrdiff_t>(k), contacts[k]);
    EXPECT_TRUE(outcome(particles_, joined(without)).refused()) << "without " << contacts[k];
    EXPECT_TRUE(outcome(particles_, joined(twice)).refused()) << "twice " << contacts[k];
  }
}

TEST_F(Corpus, RowsInAnotherOrderAreTheSameFrame) {
  auto lines = lines_of(particles_);
  std::swap(lines[9], lines[12]);
  std::swap(lines[10], lines[11]);
  EXPECT_TRUE(as_good(outcome(joined(lines), contacts_)));
}

TEST_F(Corpus, FramesThatAreThereTwiceAreRefused) {
  EXPECT_TRUE(outcome(particles_ + particles_, contacts_ + contacts_).refused());
}

TEST_F(Corpus, CountsThatAreWrongAreRefused) {
  for (const std::string count :
       {"0", "1", "3", "5", "-4", "4000000000", "1e300", "9223372036854775808", "4.5"}) {
    for (const std::string right : {"ATOMS\n4\n", "ENTRIES\n3\n"}) {
      if (right.find("\n" + count + "\n") != std::string::npos) continue;
      const bool of_particles = right[0] == 'A';
      std::string text = of_particles ? particles_ : contacts_;
      const std::size_t at = text.find(right) + right.size() - 2;
      text.replace(at, 1, count);
      EXPECT_TRUE((of_particles ? outcome(text, contacts_) : outcome(particles_, text)).refused()) << count;
    }
  }
}

TEST_F(Corpus, LineEndsOfWindowsChangeNothing) {
  std::string particles, contacts;
  for (const auto& line : lines_of(particles_)) particles += line.substr(0, line.size() - 1) + "\r\n";
  for (const auto& line : lines_of(contacts_)) contacts += line.substr(0, line.size() - 1) + "\r\n";
  EXPECT_TRUE(as_good(outcome(particles, contacts)));
}

/// Replaces the word that contains the position by another.
std::string with_word(const std::string& text, std::size_t begin, const std::string& word) {
  const auto end = text.find_first_of(" \n", begin);
  return text.substr(0, begin) + word + text.substr(end);
}

TEST_F(Corpus, WordsThatAreNoNumbersAreRefusedWhereverANumberIsRead) {
  // Columns that the averages do not need (z; x1 y1 x2 y2, fn ft, xi, vn vt) may hold anything.
  const std::string needed_of_particles = "1111011111", needed_of_contacts = "1100001111100000";
  for (const std::string word :
       {"nan", "inf", "-inf", "1e999", "1,5", "0x10", "--1", "", "1e", "one", "\xff\xfe"}) {
    for (const bool of_particles : {true, false}) {
      const std::string& text = of_particles ? particles_ : contacts_;
      const std::string& needed = of_particles ? needed_of_particles : needed_of_contacts;
      std::size_t at = text.find("\n7 ") + 1;
      for (const char used : needed) {
        const auto broken = with_word(text, at, word);
        if (used == '1') {
          EXPECT_TRUE((of_particles ? outcome(broken, contacts_) : outcome(particles_, broken)).refused())
              << "'" << word << "' at " << at << (of_particles ? " of the particles" : " of the contacts");
        }
        at = text.find(' ', at) + 1;
      }
    }
  }
}

TEST_F(Corpus, BytesAtRandomPlacesGiveAnErrorOrNumbers) {
  std::mt19937 generator(7);
  int refused = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::string texts[2] = {particles_, contacts_};
    std::string& text = texts[generator() % 2];
    for (unsigned k = 0; k <= generator() % 3; ++k) {
      char& byte = text[generator() % text.size()];
      byte = generator() % 2 ? static_cast<char>(byte ^ (1 << (generator() % 8)))
                             : static_cast<char>(generator());
    }
    const auto result = outcome(texts[0], texts[1]);
    refused += result.refused();
    // A digit that became another digit cannot be noticed; what comes out is finite or undefined, nothing
    // else.
    if (!result.refused()) {
      EXPECT_TRUE(result.has_numbers());
    }
  }
  EXPECT_GT(refused, 1000);
}

TEST_F(Corpus, FilesOfJunkAreRefused) {
  std::mt19937 generator(11);
  for (int trial = 0; trial < 100; ++trial) {
    std::string junk(generator() % 2000, '\0');
    for (char& byte : junk) byte = static_cast<char>(generator());
    EXPECT_TRUE(outcome(junk, contacts_).refused());
    EXPECT_TRUE(outcome(particles_, "\x1f\x8b" + junk).refused()) << "begins like gzip";
    EXPECT_TRUE(outcome("ITEM: TIMESTEP\n0\n" + junk, contacts_).refused());
  }
}

}  // namespace
}  // namespace mikromakro
