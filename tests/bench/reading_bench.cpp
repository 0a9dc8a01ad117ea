// SPDX-License-Identifier: GPL-2.0-or-later
// How fast frames are read and averaged, all ways side by side in one run (medians of interleaved
// repetitions), and how much memory that takes:
//   build/bin/reading_bench [REPETITIONS]
//   build/bin/reading_bench --memory
// Rates are bytes of text per second, for HDF5 those of the same frames as text. "cpu" is the processor time
// of all threads, "wall" what a clock shows.
#include <fast_float/fast_float.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numeric>
#include <span>
#include <sstream>
#include <vector>

#include "averaging/parallel/ordered_sums.h"
#include "averaging/volumes/ring_volumes.h"
#include "dump_scene.h"
#include "io/hdf5/chunk_reader.h"
#include "io/snapshot/snapshot_layout.h"
#include "io/snapshot/snapshot_writer.h"

namespace mikromakro::bench {
namespace {

constexpr int frame_count = 40;

Averager tables_1_and_2() {
  FieldOptions numbers;
  numbers.normal_stiffness = 352.1;
  return {std::make_unique<const RingVolumes>(Eigen::Vector2d::Zero(), equal_ring_edges(0.1032, 0.2524, 60),
                                              0.006),
          make_weight("sliced"),
          make_fields({}, numbers),
          {{1, 2}, Branch::radius}};
}

FrameSource source_of(const std::vector<std::string>& files, const Averager& averager) {
  FrameSource source;
  if (files.size() == 1) {
    source.snapshot_files = files;
  } else {
    source.particle_files = {files[0]};
    source.contact_files = {files[1]};
  }
  source.particles_needed = averager.particles_needed();
  source.contacts_needed = averager.contacts_needed();
  return source;
}

void read_all(const FrameSource& source) {
  FrameStream stream(source);
  Frame frame;
  while (stream.next(frame)) {
  }
}

void average_all(const FrameSource& source, const Averager& averager, int threads) {
  FrameStream stream(source);
  sum_in_order([&] { return stream.take(); }, averager, threads, [](const FrameSums&) {});
}

// What no reader of text can beat: every word of the files as a number, nothing else.
double parse_only(const std::string& text) {
  double sum = 0;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    double number = 0;
    const auto [stop, code] = fast_float::from_chars(at, end, number);
    sum += number;
    at = code == std::errc() ? stop : at + 1;
    while (at != end && (*at == ' ' || *at == '\n')) ++at;
  }
  return sum;
}

std::string content(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

void write_gzip(const std::string& from, const std::string& to) {
  const std::string text = content(from);
  gzFile file = gzopen(to.c_str(), "wb1");
  gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
}

void write_snapshots(const Dumps& dumps, const std::string& to) {
  FrameSource source;
  source.particle_files = {dumps.particles};
  source.contact_files = {dumps.contacts};
  FrameStream stream(source);
  SnapshotWriter writer(to, "bench 1", 0);
  for (Frame frame; stream.next(frame);) writer.add(stream.raw(), frame.particles);
  writer.close();
}

// One column of contacts of all frames, 8-byte numbers with checksums. `decoded`: by our reader as a whole;
// without, what it leaves to one thread at a time.
double sum_of_chunks(const std::string& file, bool decoded) {
  const Hdf5File opened = Hdf5File::open(file);
  ChunkReader reader(opened.dataset(snapshot::contacts + "fx"));
  std::vector<double> numbers(opened.dataset(snapshot::contacts + "fx").shape()[0]);
  const PackedNumbers packed = reader.take(0, numbers.size());
  if (decoded) packed.unpack(0, std::span<double>(numbers));
  return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

double sum_by_hdf5(const std::string& file) {
  const Hdf5File opened = Hdf5File::open(file);
  const Hdf5Dataset column = opened.dataset(snapshot::contacts + "fx");
  std::vector<double> numbers(column.shape()[0]);
  column.read<double>({{0}, column.shape()}, numbers);
  return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

struct Case {
  std::string name;
  std::function<void()> run;
  std::vector<double> wall = {}, cpu = {};
};

double processor_time() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void measure(std::vector<Case>& cases, int repetitions) {
  for (int i = 0; i <= repetitions; ++i) {
    for (Case& tested : cases) {
      const auto begin = std::chrono::steady_clock::now();
      const double cpu = processor_time();
      tested.run();
      if (i == 0) continue;  // to warm up
      tested.cpu.push_back(processor_time() - cpu);
      tested.wall.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
  }
}

void print(const std::vector<Case>& cases, std::int64_t bytes) {
  fmt::print("{:<44} {:>10} {:>10} {:>12} {:>12}\n", "", "cpu ms/fr", "wall ms/fr", "cpu MB/s", "wall MB/s");
  for (const Case& tested : cases) {
    const double cpu = median(tested.cpu), wall = median(tested.wall);
    fmt::print("{:<44} {:>10.3f} {:>10.3f} {:>12.0f} {:>12.0f}\n", tested.name, 1e3 * cpu / frame_count,
               1e3 * wall / frame_count, 1e-6 * static_cast<double>(bytes) / cpu,
               1e-6 * static_cast<double>(bytes) / wall);
  }
}

void throughput(int repetitions) {
  const TemporaryFolder folder;
  const Dumps dumps = write_dumps(folder, frame_count);
  write_snapshots(dumps, folder.path("s.h5"));
  write_gzip(dumps.particles, folder.path("particles.gz"));
  write_gzip(dumps.contacts, folder.path("contacts.gz"));
  const Averager averager = tables_1_and_2();
  const FrameSource text = source_of({dumps.particles, dumps.contacts}, averager);
  const FrameSource gzip = source_of({folder.path("particles.gz"), folder.path("contacts.gz")}, averager);
  const FrameSource hdf5 = source_of({folder.path("s.h5")}, averager);
  FrameSource all_of_text = text, all_of_hdf5 = hdf5;
  all_of_text.particles_needed = all_of_text.contacts_needed = 0;
  all_of_hdf5.particles_needed = all_of_hdf5.contacts_needed = 0;
  const std::string bytes = content(dumps.particles) + content(dumps.contacts);
  double sum = 0;
  std::vector<Case> cases = {{"parse only (fast_float, no frames)", [&] { sum += parse_only(bytes); }},
                             {"text, every column", [&] { read_all(all_of_text); }},
                             {"text, columns of Tables 1 and 2", [&] { read_all(text); }},
                             {"HDF5, every column", [&] { read_all(all_of_hdf5); }},
                             {"HDF5, columns of Tables 1 and 2", [&] { read_all(hdf5); }}};
  for (const auto& [name, source] :
       {std::pair("text", text), std::pair("gzip", gzip), std::pair("HDF5", hdf5)})
    for (const int threads : {1, 2})
      cases.push_back(
          {fmt::format("{}, read and averaged, {} thread{}", name, threads, threads > 1 ? "s" : ""),
           [&averager, source = source, threads] { average_all(source, averager, threads); }});
  const std::size_t taken = cases.size(), by_hdf5 = taken + 2;
  cases.push_back(
      {"HDF5, one column, chunks taken", [&] { sum += sum_of_chunks(folder.path("s.h5"), false); }});
  cases.push_back({"HDF5, one column, chunks taken and decoded",
                   [&] { sum += sum_of_chunks(folder.path("s.h5"), true); }});
  cases.push_back({"HDF5, one column, H5Dread", [&] { sum += sum_by_hdf5(folder.path("s.h5")); }});
  measure(cases, repetitions);
  fmt::print(
      "{} frames of 3800 discs and 4700 contacts, {:.1f} MB of text, {} repetitions (checksum {:.3g})\n",
      frame_count, 1e-6 * static_cast<double>(dumps.bytes), repetitions, sum);
  print(cases, dumps.bytes);
  const auto ratio = [&](std::size_t slow, std::size_t fast, std::vector<double> Case::*clock) {
    return median(cases[slow].*clock) / median(cases[fast].*clock);
  };
  fmt::print("HDF5 over text, cpu: {:.1f} (every column {:.1f})\n", ratio(2, 4, &Case::cpu),
             ratio(1, 3, &Case::cpu));
  fmt::print("H5Dread over taking chunks, which one thread at a time can do, cpu: {:.1f}\n",
             ratio(by_hdf5, taken, &Case::cpu));
  fmt::print("averaging beyond reading, cpu: {:.2f} ms per frame\n",
             1e3 * (median(cases[5].cpu) - median(cases[2].cpu)) / frame_count);
  fmt::print("two threads over one, wall: text {:.2f}, gzip {:.2f}, HDF5 {:.2f}\n", ratio(5, 6, &Case::wall),
             ratio(7, 8, &Case::wall), ratio(9, 10, &Case::wall));
}

// Peak memory of a child that does `action`, MB.
double peak_memory(const std::function<void()>& action) {
  const pid_t child = fork();
  if (child == 0) {
    action();
    _exit(0);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  return 1e-3 * static_cast<double>(usage.ru_maxrss) * 1.024;
}

void memory() {
  for (const std::int64_t bytes : {std::int64_t{200'000'000}, std::int64_t{2'000'000'000}}) {
    const TemporaryFolder folder;
    const Dumps dumps = write_dumps(folder, 0, bytes);
    for (const int threads : {1, 2}) {
      const double used = peak_memory([&] {
        const Averager averager = tables_1_and_2();
        average_all(source_of({dumps.particles, dumps.contacts}, averager), averager, threads);
      });
      fmt::print("{:.0f} MB of text, {} thread{}: {:.1f} MB at most\n",
                 1e-6 * static_cast<double>(dumps.bytes), threads, threads > 1 ? "s" : "", used);
    }
  }
}

}  // namespace
}  // namespace mikromakro::bench

int main(int argc, char** argv) {
  const std::string argument = argc > 1 ? argv[1] : "9";
  argument == "--memory" ? mikromakro::bench::memory()
                         : mikromakro::bench::throughput(std::max(1, std::atoi(argument.c_str())));
}
