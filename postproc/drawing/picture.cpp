// SPDX-License-Identifier: GPL-2.0-or-later
#include "drawing/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "averaging/periodic_images.h"
#include "drawing/colour_bar.h"
#include "drawing/scale_numbers.h"
#include "model/error.h"

namespace mikromakro {
namespace {

constexpr double largest_height = 30000;

class Painter {
 public:
  Painter(const Frame& frame, const PictureStyle& style, const PictureScales& scales, Canvas::Kind kind)
      : frame_(frame),
        style_(style),
        scales_(scales),
        letter_(style.width / 62.0),
        images_(frame.box, window_of(scales)) {
    const Box window = window_of(scales);
    const double margin = letter_;
    const double column = style.quantity != nullptr ? 7.5 * letter_ : 0.0;
    corner_ = {margin, margin};
    scale_ = (style.width - 2 * margin - column) / window.length().x();
    opposite_ = corner_ + scale_ * window.length();
    origin_ = {corner_.x() - scale_ * window.low.x(), opposite_.y() + scale_ * window.low.y()};
    const double height = opposite_.y() + 3 * letter_;
    if (!(height < largest_height))
      throw bad_input({"--box"}, "the picture is too tall", "at most 30000 pixels",
                      fmt::format("{:.0f}", height));
    canvas_ = std::make_unique<Canvas>(kind, style.width, static_cast<int>(std::lround(height)));
  }

  std::string paint() {
    canvas_->show_only(corner_, opposite_);
    discs();
    if (style_.network) network();
    if (style_.chains) chains();
    canvas_->show_all();
    if (style_.border) canvas_->frame(corner_, opposite_, 0.06 * letter_, colours::ink);
    scale_bar();
    if (style_.chains && scales_.mean_force > 0) chain_key();
    stamp();
    if (style_.quantity != nullptr) {
      draw_colour_bar(*canvas_, *style_.quantity, scales_, {opposite_.x() + 1.2 * letter_, corner_.y()},
                      opposite_, letter_);
    }
    return canvas_->encoded();
  }

 private:
  static Box window_of(const PictureScales& scales) {
    return scales.window.value_or(Box{{0, 0}, {1, 1}, {}});
  }

  Pixel at(const Eigen::Vector2d& point) const {
    return {origin_.x() + scale_ * point.x(), origin_.y() - scale_ * point.y()};
  }

  double mean_radius() const {
    double sum = 0;
    for (const Particle& particle : frame_.particles) sum += particle.radius;
    return scale_ * sum / static_cast<double>(std::max<std::size_t>(frame_.particles.size(), 1));
  }

  void discs() {
    const ColourScale colour_of(scales_.colours);
    const std::vector<double> values = style_.quantity != nullptr
                                           ? disc_values(frame_, style_.quantity->quantity, style_.height)
                                           : std::vector<double>(frame_.particles.size());
    const double line_width = std::max(0.05 * mean_radius(), 0.25);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Particle& particle = frame_.particles[i];
      const Colour fill = !is_bulk(particle, style_)   ? colours::wall
                          : style_.quantity == nullptr ? colours::plain
                                                       : colour_of(values[i]);
      images_.of(particle.position, particle.radius, places_);
      for (const Eigen::Vector2d& place : places_)
        canvas_->disc(at(place), scale_ * particle.radius, fill, colours::outline, line_width);
    }
  }

  // From the centre of disc 1 to that of disc 2 or of its touching image, or to the wall.
  Eigen::Vector2d line_of(const Contact& contact) const {
    const Particle& first = frame_.particles[static_cast<std::size_t>(contact.index1)];
    const double reach = first.radius - (std::isnan(contact.overlap) ? 0 : contact.overlap);
    if (contact.with_wall()) return reach * contact.normal;
    const Particle& second = frame_.particles[static_cast<std::size_t>(contact.index2)];
    const Eigen::Vector2d branch = (reach + second.radius) * contact.normal;
    const Eigen::Vector2d straight = second.position - first.position;
    return (straight - branch).norm() > 0.5 * branch.norm() ? branch : straight;
  }

  // A contact across a periodic boundary is drawn on both sides.
  void contact_line(const Contact& contact, double width, const Colour& colour) {
    const Eigen::Vector2d half = 0.5 * line_of(contact);
    const Particle& first = frame_.particles[static_cast<std::size_t>(contact.index1)];
    images_.of(first.position + half, half.norm() + 0.5 * width / scale_, places_);
    for (const Eigen::Vector2d& middle : places_)
      canvas_->line(at(middle - half), at(middle + half), width, colour);
  }

  void network() {
    const double width = std::max(network_width * mean_radius(), 0.5);
    for (const Contact& contact : frame_.contacts) contact_line(contact, width, colours::network);
  }

  double width_of(double force) const { return chain_width * mean_radius() * force / scales_.mean_force; }

  // The strongest on top, each with a light edge so that chains stand out from discs of any colour.
  void chains() {
    if (scales_.mean_force == 0) return;
    const auto force = [this](std::size_t i) {
      return -frame_.contacts[i].force.dot(frame_.contacts[i].normal);
    };
    std::vector<std::size_t> order(frame_.contacts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return std::abs(force(a)) < std::abs(force(b)); });
    const double edge = style_.quantity != nullptr ? halo_width * mean_radius() : 0.0;
    // All edges first, so that none cuts through a chain where its contacts join.
    for (const std::size_t i : order) {
      const double width = width_of(std::abs(force(i)));
      if (edge > 0 && width > 0)
        contact_line(frame_.contacts[i], width + 2 * std::min(edge, width), colours::halo);
    }
    for (const std::size_t i : order) {
      const double width = width_of(std::abs(force(i)));
      if (width > 0)
        contact_line(frame_.contacts[i], width, force(i) > 0 ? colours::compression : colours::tension);
    }
  }

  double foot() const { return opposite_.y() + 1.6 * letter_; }

  void scale_bar() {
    const double width = opposite_.x() - corner_.x();
    const double length = round_below(0.2 * width / scale_);
    const ScaledUnit unit = scaled_unit(length, "m");
    const Pixel from{corner_.x(), foot()};
    const Pixel to = from + Pixel(scale_ * length, 0);
    const double half = 0.14 * letter_;
    const std::array<Pixel, 4> bar = {{{from.x(), from.y() - half},
                                       {to.x(), from.y() - half},
                                       {to.x(), from.y() + half},
                                       {from.x(), from.y() + half}}};
    canvas_->polygon(bar, colours::ink);
    canvas_->text(to + Pixel(0.5 * letter_, 0), label_text(length / unit.factor) + " " + unit.unit, letter_,
                  {0, 0.5});
  }

  // A line for a round force value, with its label, for each sign that occurs.
  void chain_key() {
    const double force = round_below(2 * scales_.mean_force);
    const ScaledUnit unit = scaled_unit(force, "N");
    const std::string size = label_text(force / unit.factor) + " " + unit.unit;
    const bool pulls =
        std::any_of(frame_.contacts.begin(), frame_.contacts.end(),
                    [](const Contact& contact) { return contact.force.dot(contact.normal) > 0; });
    double x = corner_.x() + 0.36 * (opposite_.x() - corner_.x());
    const auto entry = [&](const Colour& colour, const std::string& words) {
      const Pixel from{x, foot()};
      canvas_->line(from, from + Pixel(1.6 * letter_, 0), width_of(force), colour);
      canvas_->text(from + Pixel(2.4 * letter_, 0), words, letter_, {0, 0.5});
      x += (4 + 0.55 * static_cast<double>(words.size())) * letter_;
    };
    entry(colours::compression, size + " compression");
    if (pulls) entry(colours::tension, "tension");
  }

  void stamp() {
    const double time =
        style_.time_step > 0 ? style_.time_step * static_cast<double>(frame_.step) : frame_.time;
    const std::string words =
        std::isnan(time) ? fmt::format("step {}", frame_.step) : fmt::format("t = {:.6g} s", time);
    canvas_->text({opposite_.x(), foot()}, words, letter_, {1, 0.5});
  }

  const Frame& frame_;
  const PictureStyle& style_;
  const PictureScales& scales_;
  double letter_;
  PeriodicImages images_;
  std::vector<Eigen::Vector2d> places_;  // reused memory
  Pixel corner_, opposite_, origin_;
  double scale_ = 1;
  std::unique_ptr<Canvas> canvas_;
};

}  // namespace

std::string draw_picture(const Frame& frame, const PictureStyle& style, const PictureScales& scales,
                         Canvas::Kind kind) {
  return Painter(frame, style, scales, kind).paint();
}

}  // namespace mikromakro
