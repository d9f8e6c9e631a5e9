#include <fmt/format.h>
#include <muParser.h>

#include <numbers>

#include "core/error.h"
#include "core/parallel.h"
#include "mesh/scalar_field.h"

namespace havs {
namespace {

/// One parser with its own variables: muparser's parsers are not shared between threads.
class Expression {
 public:
  explicit Expression(const std::string& text) {
    parser_.DefineVar("x", &at_.x);
    parser_.DefineVar("y", &at_.y);
    parser_.DefineVar("z", &at_.z);
    parser_.DefineConst("pi", std::numbers::pi);
    parser_.SetExpr(text);
  }
  double operator()(const Vec3& point) {
    at_ = point;
    return parser_.Eval();
  }

 private:
  Vec3 at_{0};
  mu::Parser parser_;
};

}  // namespace

Field fieldFromExpression(const TetMesh& mesh, const std::string& name, const std::string& expression) {
  Field field{name, 1, std::vector<double>(mesh.points.size())};
  try {
    Expression{expression}(Vec3(0));  // so that a mistake shows here, not in a thread
    parallelBlocks(0, mesh.points.size(), 16384, [&](std::size_t begin, std::size_t end) {
      Expression value(expression);
      for (std::size_t i = begin; i < end; ++i) field.values[i] = value(mesh.points[i]);
    });
  } catch (const mu::ParserError& error) {
    failInput(fmt::format("{} (position {})", error.GetMsg(), error.GetPos()),
              fmt::format("expression '{}'", expression), "write it in x, y and z, for example sqrt(x^2 + y^2)");
  }
  return field;
}

}  // namespace havs
