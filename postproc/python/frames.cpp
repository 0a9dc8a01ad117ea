// SPDX-License-Identifier: GPL-2.0-or-later
#include "python/frames.h"

#include <pybind11/numpy.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "model/error.h"
#include "python/keywords.h"
#include "python/number_array.h"
#include "python/turn.h"
#include "verbs/input_options.h"
#include "verbs/warnings.h"

namespace py = pybind11;

namespace mikromakro {
namespace {

struct Member {
  const char* name;
  const char* format;
  std::size_t offset;
};

constexpr std::size_t second = sizeof(double);  // component of a vector

// Eigen's vectors have standard layout, but are members of no aggregate.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Winvalid-offsetof"
const std::vector<Member> particle_members = {{"id", "i8", offsetof(Particle, id)},
                                              {"type", "i4", offsetof(Particle, type)},
                                              {"x", "f8", offsetof(Particle, position)},
                                              {"y", "f8", offsetof(Particle, position) + second},
                                              {"radius", "f8", offsetof(Particle, radius)},
                                              {"vx", "f8", offsetof(Particle, velocity)},
                                              {"vy", "f8", offsetof(Particle, velocity) + second},
                                              {"omegaz", "f8", offsetof(Particle, spin)},
                                              {"mass", "f8", offsetof(Particle, mass)}};
const std::vector<Member> contact_members = {
    {"id1", "i8", offsetof(Contact, id1)},           {"id2", "i8", offsetof(Contact, id2)},
    {"index1", "i4", offsetof(Contact, index1)},     {"index2", "i4", offsetof(Contact, index2)},
    {"nx", "f8", offsetof(Contact, normal)},         {"ny", "f8", offsetof(Contact, normal) + second},
    {"overlap", "f8", offsetof(Contact, overlap)},   {"fx", "f8", offsetof(Contact, force)},
    {"fy", "f8", offsetof(Contact, force) + second}, {"xi", "f8", offsetof(Contact, spring)}};
#pragma GCC diagnostic pop

py::dtype dtype_of(const std::vector<Member>& members, std::size_t size) {
  py::list names, formats, offsets;
  for (const Member& member : members) {
    names.append(member.name);
    formats.append(member.format);
    offsets.append(member.offset);
  }
  return {names, formats, offsets, static_cast<py::ssize_t>(size)};
}

// A view that keeps `owner` alive.
template <typename Row>
py::array view_of(const std::vector<Row>& rows, const std::vector<Member>& members, const py::object& owner) {
  py::array view(dtype_of(members, sizeof(Row)), {static_cast<py::ssize_t>(rows.size())},
                 {static_cast<py::ssize_t>(sizeof(Row))}, rows.data(), owner);
  view.attr("flags").attr("writeable") = false;
  return view;
}

const Frame& frame_of(const py::object& self) {
  return *self.cast<std::shared_ptr<Frame>>();
}

py::array box_of(const Frame& frame) {
  const Box& box = frame.box;
  py::array_t<double> limits({2, 2});
  auto numbers = limits.mutable_unchecked<2>();
  for (py::ssize_t axis = 0; axis < 2; ++axis) {
    numbers(axis, 0) = box.low[axis];
    numbers(axis, 1) = box.high[axis];
  }
  return limits;
}

// Sums numbers of contacts over those of each disc.
py::array sum_over_contacts(const Frame& frame, const py::object& given, const py::object& of_second) {
  const NumberArray of_first = number_array("sum_over_contacts", given);
  const NumberArray others = of_second.is_none() ? of_first : number_array("sum_over_contacts", of_second);
  const auto contacts = std::ssize(frame.contacts);
  if (of_first.ndim() != 1 || others.ndim() != 1 || of_first.size() != contacts || others.size() != contacts)
    throw py::value_error("sum_over_contacts: expected one number for each of the " +
                          std::to_string(contacts) + " contacts");
  py::array_t<double> sums(std::ssize(frame.particles));
  double* sum = sums.mutable_data();
  std::fill_n(sum, sums.size(), 0.0);
  for (py::ssize_t i = 0; i < contacts; ++i) {
    const Contact& contact = frame.contacts[static_cast<std::size_t>(i)];
    if (contact.index1 >= 0) sum[contact.index1] += of_first.data()[i];
    if (contact.index2 >= 0) sum[contact.index2] += others.data()[i];
  }
  return sums;
}

std::string repr_of(const Frame& frame) {
  return "<mikromakro.Frame: step " + std::to_string(frame.step) + ", " +
         std::to_string(frame.particles.size()) + " discs, " + std::to_string(frame.contacts.size()) +
         " contacts>";
}

// Reads one frame ahead of Python at most.
class Frames {
 public:
  Frames(const py::dict& keywords, Hooks hooks) : hooks_(std::move(hooks)) {
    CLI::App app;
    add_input_options(app, options_);
    set_options(app, "frames", keywords);
    open();
  }
  ~Frames() { Turn::close(std::move(stream_)); }
  Frames(const Frames&) = delete;
  Frames& operator=(const Frames&) = delete;

  py::object next() {
    std::shared_ptr<Frame> frame;
    try {
      frame = read();
    } catch (const Error& error) {
      if (error.kind() != Error::Kind::steps_come_again || options_.look_through) throw;
      options_.look_through = true;
      open();
      for (std::int64_t i = 0; i < given_; ++i) read();
      frame = read();
    }
    if (!frame) {
      if (given_ == 0) throw source_.no_frame_selected();
      throw py::stop_iteration();
    }
    ++given_;
    return python_frame(std::move(frame));
  }

 private:
  void open() {
    in_turn(hooks_, [&] {
      source_ = frame_source(options_);
      source_.particles_needed = column_set(ParticleColumn::id);
      stream_ = std::make_unique<FrameStream>(source_);
      return 0;
    });
  }

  // Null after the last frame.
  std::shared_ptr<Frame> read() {
    return in_turn(hooks_, [&] {
      auto frame = std::make_shared<Frame>();
      if (!stream_ || !stream_->next(*frame)) {
        if (stream_) tell(*source_.notes);
        stream_.reset();
        frame.reset();
      }
      return frame;
    });
  }

  Hooks hooks_;
  InputOptions options_;
  FrameSource source_;
  std::unique_ptr<FrameStream> stream_;
  std::int64_t given_ = 0;
};

}  // namespace

py::object python_frame(std::shared_ptr<const Frame> frame) {
  return py::cast(std::const_pointer_cast<Frame>(std::move(frame)));
}

void add_frames(py::module_& module) {
  py::class_<Frame, std::shared_ptr<Frame>>(module, "Frame",
                                            "Discs and contacts at one time step, as arrays; see frames().")
      .def_readonly("step", &Frame::step)
      .def_readonly("time", &Frame::time)
      .def_readonly("index", &Frame::index)
      .def_readonly("run", &Frame::run)
      .def_readonly("contacts_known", &Frame::contacts_known)
      .def_property_readonly("box", box_of)
      .def_property_readonly(
          "periodic",
          [](const Frame& frame) { return py::make_tuple(frame.box.periodic[0], frame.box.periodic[1]); })
      .def_property_readonly(
          "particles",
          [](const py::object& self) { return view_of(frame_of(self).particles, particle_members, self); })
      .def_property_readonly(
          "contacts",
          [](const py::object& self) { return view_of(frame_of(self).contacts, contact_members, self); })
      .def("sum_over_contacts", sum_over_contacts, py::arg("of_first"), py::arg("of_second") = py::none(),
           "Shape (discs,): the sum over the contacts of each disc of numbers given for each contact, "
           "of_first for "
           "its disc 1 and of_second (default the same) for its disc 2.")
      .def("__repr__", repr_of);
  py::class_<Frames>(module, "Frames")
      .def(py::init([](const py::dict& keywords, py::object warn) {
        return std::make_unique<Frames>(keywords, Hooks{py::none(), std::move(warn)});
      }))
      .def("__iter__", [](const py::object& self) { return self; })
      .def("__next__", &Frames::next);
}

}  // namespace mikromakro
