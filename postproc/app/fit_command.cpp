#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "app/commands.h"
#include "fit/exponential_profile.h"
#include "io/csv_reader.h"
#include "io/error.h"
#include "io/json_object.h"
#include "options/value_checks.h"

namespace mikromakro {
namespace {

struct FitOptions {
  std::string file, column = "v_phi", weights = "none";
  std::vector<double> range;
  double ri = std::nan("");
  double omega = std::nan("");
  bool json = false;
};

struct FitResult {
  ExponentialProfile profile;
  double r_i = 0;
  double scale = 0;  // Omega R_i, nan when --omega is not given
  std::string unit;  // of the column
};

constexpr std::string_view unit_of_velocity = "m/s";

// Whether the rows are rings one after the other, where the table gives their edges: a row that was doubled,
// or whose radius lies in another ring, would count wrongly without a word.
void check_rings(const CsvTable& table) {
  if (!table.has("r_inner") || !table.has("r_outer")) return;
  const Eigen::ArrayXd inner = table.column("r_inner"), outer = table.column("r_outer"),
                       r = table.column("r");
  const bool sectors = table.has("phi_begin");
  for (Eigen::Index i = 0; i < table.rows(); ++i) {
    if (!(inner[i] <= r[i] && r[i] <= outer[i]))
      throw bad_input(table.row_place(i), "r lies outside of its ring",
                      fmt::format("{} to {}", inner[i], outer[i]), fmt::format("{}", r[i]));
    if (i == 0 || sectors) continue;
    const double overlap = outer[i - 1] - inner[i];
    constexpr double rounding = 1e-9;  // of edges that are written with fewer digits
    if (overlap > rounding * outer[i])
      throw bad_input(table.row_place(i), "rings overlap or are there twice",
                      fmt::format("r_inner of at least {}", outer[i - 1]), fmt::format("{}", inner[i]));
  }
}

FitResult fit_file(const FitOptions& options) {
  const CsvTable table(options.file);
  if (!table.has("r"))
    throw bad_input({options.file}, "the table is not one of rings", "a column r, as of average --rings",
                    "none");
  ProfilePoints points{table.column("r"), table.column(options.column), {}};
  if (options.weights == "errors") points.error = table.column(options.column + "_err");
  if (table.rows() == 0) throw bad_input({options.file}, "the table is empty", "rows of numbers", "none");
  check_rings(table);
  if (options.range.size() == 2) {
    const bool ordered = options.range[0] < options.range[1];
    if (!ordered)
      throw bad_input({"--range"}, "the range is empty", "R1 < R2",
                      fmt::format("{} {}", options.range[0], options.range[1]));
    const auto inside = points.r >= options.range[0] && points.r <= options.range[1];
    points.v = inside.select(points.v, std::nan("")).eval();
  }
  FitResult result;
  result.unit = table.unit(options.column);
  if (!std::isnan(options.omega) && !result.unit.empty() && result.unit != unit_of_velocity)
    throw bad_input({"--omega"}, fmt::format("{} is no velocity", options.column),
                    fmt::format("a column in {}", unit_of_velocity), result.unit);
  result.r_i = std::isnan(options.ri) ? table.column("r_inner")[0] : options.ri;
  if (options.omega == 0)
    throw bad_input({"--omega"}, "the wheel does not turn", "a rate that is not 0", "0");
  if (!std::isnan(options.omega) && result.r_i == 0)
    throw bad_input({"--omega"}, "a wheel of no radius has no velocity",
                    "--ri above 0, or rings that begin there", "0");
  result.scale = options.omega * result.r_i;
  result.profile = fit_exponential(points, result.r_i);
  return result;
}

Estimate scaled(const Estimate& v0, double scale) {
  const Estimate by{v0.value / scale, v0.low / scale, v0.high / scale};
  return scale < 0 ? Estimate{by.value, by.high, by.low} : by;
}

void print_json(const FitOptions& options, const FitResult& result) {
  JsonObject json;
  const auto add = [&json](const std::string& key, const Estimate& estimate) {
    json.add(key, estimate.value);
    json.add(key + "_low", estimate.low);
    json.add(key + "_high", estimate.high);
  };
  add("v0", result.profile.v0);
  add("s", result.profile.s);
  json.add("r_i", result.r_i);
  json.add("omega", options.omega);
  add("v0_scaled", scaled(result.profile.v0, result.scale));
  json.add("rings", std::int64_t{result.profile.points});
  json.add("residual_rms", result.profile.residual_rms);
  fmt::print("{}\n", json.text());
}

void print_text(const FitOptions& options, const FitResult& result) {
  const auto line = [](std::string_view name, const Estimate& estimate, std::string_view unit) {
    fmt::print("{} = {:.6g}{}{} (95 %: {:.6g} to {:.6g})\n", name, estimate.value, unit.empty() ? "" : " ",
               unit, estimate.low, estimate.high);
  };
  fmt::print("{}(r) = v0 exp(-(r - R_i)/s), R_i = {:.6g} m, {} rings\n", options.column, result.r_i,
             result.profile.points);
  line("v0", result.profile.v0, result.unit);
  line("s", result.profile.s, "m");
  if (!std::isnan(result.scale)) line("v0/(Omega R_i)", scaled(result.profile.v0, result.scale), "");
  fmt::print("rms of the residuals = {:.6g} {}\n", result.profile.residual_rms,
             result.unit.empty() ? "(the table does not tell the unit)" : result.unit);
}

}  // namespace

void add_fit_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("fit", "exponential velocity profile v0 exp(-(r - R_i)/s)");
  auto options = std::make_shared<FitOptions>();
  app->add_option("file", options->file, "table of `mikromakro average`")->required();
  app->add_option("--column", options->column, "column to fit, default v_phi");
  app->add_option("--weights", options->weights,
                  "none (default): each ring counts the same; errors: by its standard error COLUMN_err")
      ->check(one_of({"none", "errors"}));
  app->add_option("--range", options->range, "R1 R2: rings with R1 <= r <= R2 only (m)")
      ->expected(2)
      ->allow_extra_args(false);
  app->add_option("--ri", options->ri, "R_i (m), default r_inner of the first ring");
  app->add_option("--omega", options->omega, "rate of rotation of the wheel (rad/s), for v0/(Omega R_i)");
  app->add_flag("--json", options->json, "print JSON");
  app->callback([options] {
    const FitResult result = fit_file(*options);
    options->json ? print_json(*options, result) : print_text(*options, result);
  });
}

}  // namespace mikromakro
