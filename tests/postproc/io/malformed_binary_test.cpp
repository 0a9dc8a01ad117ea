// SPDX-License-Identifier: GPL-2.0-or-later
// The corpus of malformed files goes on with compressed dumps, HDF5 snapshots and MercuryDPM's files; under
// the sanitizers as malformed_files_test.cpp, and with the same demand: one clear error, or a correct result.
#include <gtest/gtest.h>
#include <zlib.h>
#include <zstd.h>

#include <random>

#include "corpus.h"
#include "io/snapshot/snapshot_writer.h"

// HDF5 itself forgets memory where it meets damage.
extern "C" const char* __lsan_default_suppressions() {  // NOLINT(bugprone-reserved-identifier)
  return "leak:libhdf5";
}

namespace mikromakro {
namespace {

const std::string good_particles = TEST_DATA "/good/particles.dump";
const std::string good_contacts = TEST_DATA "/good/contacts.dump";

std::string gzipped(const std::string& text) {
  const Folder folder;
  gzFile file = gzopen(folder.path("z").c_str(), "wb");
  gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  return read_text(folder.path("z"));
}

// With the sum of the content, as the program zstd writes it.
std::string zstd_packed(const std::string& text) {
  ZSTD_CCtx* const context = ZSTD_createCCtx();
  ZSTD_CCtx_setParameter(context, ZSTD_c_checksumFlag, 1);
  std::string packed(ZSTD_compressBound(text.size()), '\0');
  packed.resize(ZSTD_compress2(context, packed.data(), packed.size(), text.data(), text.size()));
  ZSTD_freeCCtx(context);
  return packed;
}

class Compressed : public testing::TestWithParam<std::string (*)(const std::string&)> {
 protected:
  Outcome outcome(const std::string& particles) const {
    FrameSource source;
    source.particle_files = {folder_.write("particles", particles)};
    source.contact_files = {good_contacts};
    return outcome_of(source);
  }

  const Folder folder_;
  const std::string packed_ = GetParam()(read_text(good_particles));
  const Outcome good_ = outcome(packed_);
};
INSTANTIATE_TEST_SUITE_P(Corpus, Compressed, testing::Values(gzipped, zstd_packed));

TEST_P(Compressed, IsReadAsItIs) {
  EXPECT_EQ(good_.error, "");
}

// Whether it ends within a frame or within the sums behind the last one.
TEST_P(Compressed, IsRefusedOrToldWhereverItEndsTooSoon) {
  for (std::size_t length = 0; length < packed_.size(); ++length) {
    const Outcome cut = outcome(packed_.substr(0, length));
    EXPECT_TRUE(cut.refused() || (cut.told && cut.same_as(good_))) << "cut after " << length;
  }
}

// What is not the content (a name, the time of writing) may change.
TEST_P(Compressed, HasNoBitThatChangesNumbersUnnoticed) {
  int refused = 0;
  for (std::size_t at = 0; at < packed_.size(); ++at) {
    std::string broken = packed_;
    broken[at] = static_cast<char>(broken[at] ^ (1 << (at % 8)));
    const Outcome result = outcome(broken);
    refused += result.refused();
    EXPECT_TRUE(result.refused() || result.same_as(good_)) << "byte " << at;
  }
  EXPECT_GT(refused, static_cast<int>(packed_.size()) * 9 / 10);
}

class Snapshot : public testing::Test {
 protected:
  Snapshot() : bytes_(written({0, 1})), good_(outcome(bytes_)) {}

  /// A file of the good frames by their numbers.
  std::string written(const std::vector<int>& order) const {
    FrameSource source;
    source.particle_files = {good_particles};
    source.contact_files = {good_contacts};
    SnapshotWriter writer(folder_.path("w.h5"), "test 1", 0);
    for (const int wanted : order) {
      FrameStream stream(source);
      Frame frame;
      for (int i = 0; i <= wanted; ++i) stream.next(frame);
      writer.add(stream.raw(), frame.particles);
    }
    writer.close();
    return read_text(folder_.path("w.h5"));
  }

  Outcome outcome(const std::string& bytes) const {
    FrameSource source;
    source.snapshot_files = {folder_.write("s.h5", bytes)};
    return outcome_of(source);
  }

  const Folder folder_;
  const std::string bytes_;
  const Outcome good_;
};

TEST_F(Snapshot, IsReadAsItIs) {
  EXPECT_EQ(good_.error, "");
}

TEST_F(Snapshot, IsRefusedWhereverItEndsTooSoon) {
  for (std::size_t length = 0; length < bytes_.size(); length += 1 + bytes_.size() / 300)
    EXPECT_TRUE(outcome(bytes_.substr(0, length)).refused()) << "cut after " << length;
}

TEST_F(Snapshot, OfFramesThatAreThereTwiceIsRefused) {
  EXPECT_TRUE(outcome(written({0, 0})).refused());
  EXPECT_TRUE(outcome(written({1, 0})).refused());
}

// Every chunk and every table of contents has a sum of its own; what has none is checked or has no meaning.
TEST_F(Snapshot, HasNoBitThatChangesNumbersUnnoticed) {
  std::mt19937 generator(3);
  // Most of the file is unused places of its chunks: every second trial where there is something.
  std::vector<std::size_t> filled;
  for (std::size_t at = 0; at < bytes_.size(); ++at)
    if (bytes_[at] != 0) filled.push_back(at);
  int refused = 0;
  for (int trial = 0; trial < 600; ++trial) {
    std::string broken = bytes_;
    const std::size_t at = trial % 2 == 0 ? generator() % bytes_.size() : filled[generator() % filled.size()];
    broken[at] = static_cast<char>(broken[at] ^ (1 << (generator() % 8)));
    const Outcome result = outcome(broken);
    refused += result.refused();
    EXPECT_TRUE(result.refused() || result.same_as(good_)) << "byte " << at;
  }
  EXPECT_GT(refused, 200);
}

TEST_F(Snapshot, OfJunkIsRefused) {
  std::mt19937 generator(5);
  for (int trial = 0; trial < 50; ++trial) {
    std::string junk(generator() % 4000, '\0');
    for (char& byte : junk) byte = static_cast<char>(generator());
    EXPECT_TRUE(outcome(bytes_.substr(0, 8) + junk).refused());
    EXPECT_TRUE(outcome(bytes_.substr(0, 200) + junk).refused());
  }
}

class Mercury : public testing::Test {
 protected:
  Outcome outcome(const std::string& particles, const std::string& contacts) const {
    FrameSource source;
    source.particle_files = {folder_.write("m.data", particles)};
    source.contact_files = {folder_.write("m.fstat", contacts)};
    source.density = 0.25;
    return outcome_of(source);
  }

  const Folder folder_;
  const std::string particles_ = read_text(TEST_DATA "/good/mercury.data");
  const std::string contacts_ = read_text(TEST_DATA "/good/mercury.fstat");
  const Outcome good_ = outcome(particles_, contacts_);
};

TEST_F(Mercury, IsReadAsItIs) {
  EXPECT_EQ(good_.error, "");
}

TEST_F(Mercury, EndsOfLinesOfWindowsChangeNothing) {
  const auto crlf = [](const std::string& text) {
    std::string with_returns;
    for (const auto& line : lines_of(text)) with_returns += line.substr(0, line.size() - 1) + "\r\n";
    return with_returns;
  };
  EXPECT_TRUE(outcome(crlf(particles_), crlf(contacts_)).same_as(good_));
}

// Only the rows of the last .fstat frame can be fewer without anybody seeing it: the format has no count.
TEST_F(Mercury, IsRefusedWhereverItEndsTooSoon) {
  for (std::size_t length = 0; length < particles_.size(); ++length)
    EXPECT_TRUE(outcome(particles_.substr(0, length), contacts_).refused())
        << "particles cut after " << length;
  for (std::size_t length = 0; length < contacts_.size(); ++length) {
    const std::string cut = contacts_.substr(0, length);
    const bool row_of_last_frame = cut.ends_with('\n') && length > contacts_.rfind('#');
    EXPECT_TRUE(row_of_last_frame || outcome(particles_, cut).refused()) << "contacts cut after " << length;
  }
}

TEST_F(Mercury, LinesThatAreThereTwiceAndMissingHeadersAndParticlesAreNoticed) {
  const auto particles = lines_of(particles_), contacts = lines_of(contacts_);
  const auto without = [](auto lines, std::size_t k) {
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(k));
    return joined(lines);
  };
  const auto twice = [](auto lines, std::size_t k) {
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(k), lines[k]);
    return joined(lines);
  };
  for (std::size_t k = 0; k < particles.size(); ++k) {
    EXPECT_TRUE(outcome(without(particles, k), contacts_).refused()) << "without " << particles[k];
    EXPECT_TRUE(outcome(twice(particles, k), contacts_).refused()) << "twice " << particles[k];
  }
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    EXPECT_TRUE(outcome(particles_, twice(contacts, k)).refused()) << "twice " << contacts[k];
    if (contacts[k][0] == '#') {
      EXPECT_TRUE(outcome(particles_, without(contacts, k)).refused()) << "without " << contacts[k];
    }
  }
}

TEST_F(Mercury, BytesAtRandomPlacesGiveAnErrorOrNumbers) {
  std::mt19937 generator(13);
  int refused = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    std::string texts[2] = {particles_, contacts_};
    std::string& text = texts[generator() % 2];
    char& byte = text[generator() % text.size()];
    byte =
        generator() % 2 ? static_cast<char>(byte ^ (1 << (generator() % 8))) : static_cast<char>(generator());
    const Outcome result = outcome(texts[0], texts[1]);
    refused += result.refused();
    EXPECT_TRUE(result.refused() || result.has_numbers());
  }
  EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace mikromakro
