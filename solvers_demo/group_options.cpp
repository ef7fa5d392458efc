#include "group_options.hpp"

#include <algorithm>
#include <array>

#include "lepp/geometry/error.hpp"
#include "linear_expression.hpp"

namespace lepp::demo {
namespace {

/// One GROUP=VALUE, with the option it came from for messages.
struct Assignment {
  std::string where;  ///< --dirichlet left=1
  std::string group, value;
};

Assignment split(const std::string& option, const std::string& text) {
  const auto equals = text.rfind('=');
  const std::string where = option + " " + text;
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
    throw InputError(
        where, "is not of the form GROUP=VALUE",
        "write for example " + option + " left=" + (option == "--robin" ? "10,300" : "1"));
  }
  return {where, text.substr(0, equals), text.substr(equals + 1)};
}

LinearExpression linear(const Assignment& a, const std::string& value) {
  if (const auto expression = parse_linear(value)) return *expression;
  throw InputError(a.where, "\"" + value + "\" is no number and no sum such as 1+2*x-0.5*y",
                   "write it without spaces, with x and y as the only names");
}

double positive(const Assignment& a, const std::string& value) {
  const auto number = parse_number(value);
  if (number && *number > 0) return *number;
  throw InputError(a.where, "\"" + value + "\" is no positive number", "give a number above 0");
}

bool is_called(const PhysicalGroup& group, const std::string& text) {
  return group.name == text || std::to_string(group.tag) == text;
}

/// The remedy for a wrong group: what there is of `dimension`.
template <class Entity>
std::string use_one_of(const Entities& all, const std::vector<Entity>& entities, int dimension) {
  std::string groups, tags;
  for (const PhysicalGroup& group : all.groups) {
    if (group.dimension != dimension) continue;
    groups += (groups.empty() ? "" : ", ") + std::to_string(group.tag);
    if (!group.name.empty()) groups += " \"" + group.name + "\"";
  }
  if (!groups.empty()) return "use one of the groups of this mesh: " + groups;
  for (const Entity& entity : entities) {
    tags += (tags.empty() ? "" : ", ") + std::to_string(entity.tag);
  }
  if (!tags.empty()) return "the mesh has no such groups; use one of the tags: " + tags;
  return "the mesh has neither groups nor tags there; give the geometry physical groups";
}

/// The entities of `dimension` that a name or tag stands for.
template <class EntityId, class Entity>
std::vector<EntityId> find(const Entities& all, const std::vector<Entity>& entities, int dimension,
                           const std::string& text) {
  const bool has_groups =
      std::any_of(all.groups.begin(), all.groups.end(),
                  [&](const PhysicalGroup& group) { return group.dimension == dimension; });
  std::vector<EntityId> found;
  for (std::size_t i = 0; i < entities.size(); ++i) {
    const auto& groups = entities[i].groups;
    const bool named = std::any_of(groups.begin(), groups.end(), [&](GroupId g) {
      return all[g].dimension == dimension && is_called(all[g], text);
    });
    if (named || (!has_groups && std::to_string(entities[i].tag) == text)) found.emplace_back(i);
  }
  return found;
}

std::vector<SurfaceId> surfaces(const Mesh& mesh, const Assignment& a) {
  const Entities& all = mesh.entities();
  auto found = find<SurfaceId>(all, all.surfaces, 2, a.group);
  if (!found.empty()) return found;
  throw InputError(a.where, "there is no group of surfaces \"" + a.group + "\"",
                   use_one_of(all, all.surfaces, 2));
}

BoundaryPart part(const Mesh& mesh, const Assignment& a, bool with_points) {
  const Entities& all = mesh.entities();
  BoundaryPart found{a.group, find<CurveId>(all, all.curves, 1, a.group), {}};
  if (with_points) found.points = find<PointEntityId>(all, all.points, 0, a.group);
  if (found.curves.empty() && found.points.empty()) {
    throw InputError(a.where, "there is no group of curves \"" + a.group + "\"",
                     use_one_of(all, all.curves, 1));
  }
  if (found.points.empty() && edges_of(mesh, found).empty()) {
    throw InputError(a.where, "no edge of the mesh belongs to it",
                     "mesh the geometry again with the curves of this group in it");
  }
  return found;
}

std::string name_of(const Entities& all, SurfaceId id) {
  if (id.index() >= all.surfaces.size()) return "region " + std::to_string(id.value);
  std::string name = "surface " + std::to_string(all[id].tag);
  for (const GroupId g : all[id].groups) {
    name +=
        ", group " + (all[g].name.empty() ? std::to_string(all[g].tag) : "\"" + all[g].name + "\"");
  }
  return name;
}

std::vector<double> diffusion_from(const std::vector<std::string>& texts, const Mesh& mesh) {
  std::vector<double> D(region_count(mesh), texts.empty() ? 1.0 : 0.0);
  for (const std::string& text : texts) {
    const Assignment a = split("--diffusion", text);
    const double value = positive(a, a.value);
    for (const SurfaceId s : surfaces(mesh, a)) {
      if (s.index() >= D.size()) continue;  // no triangle lies there
      if (D[s.index()] > 0) {
        throw InputError(a.where, name_of(mesh.entities(), s) + " already has a diffusion",
                         "give each surface one");
      }
      D[s.index()] = value;
    }
  }
  for (const Triangle& t : mesh.triangles()) {
    if (D[t.region().index()] > 0) continue;
    throw InputError("--diffusion", "is missing for " + name_of(mesh.entities(), t.region()),
                     use_one_of(mesh.entities(), mesh.entities().surfaces, 2));
  }
  return D;
}

std::vector<Field> source_from(const std::vector<std::string>& texts, const Mesh& mesh) {
  std::vector<Field> source(region_count(mesh));
  for (const std::string& text : texts) {
    const Assignment a = split("--source", text);
    const LinearExpression f = linear(a, a.value);
    for (const SurfaceId s : surfaces(mesh, a)) {
      if (s.index() >= source.size()) continue;
      if (source[s.index()]) {
        throw InputError(a.where, name_of(mesh.entities(), s) + " already has a source",
                         "give each surface one");
      }
      source[s.index()] = f;
    }
  }
  return source;
}

struct RobinValues {
  double alpha;
  LinearExpression outside;
};

RobinValues robin_values(const Assignment& a) {
  const auto comma = a.value.find(',');
  if (comma == std::string::npos) {
    throw InputError(a.where, "needs two values, GROUP=ALPHA,V",
                     "write for example --robin " + a.group + "=10,300");
  }
  return {positive(a, a.value.substr(0, comma)), linear(a, a.value.substr(comma + 1))};
}

Robin robin_from(const std::string& text, const Mesh& mesh) {
  const Assignment a = split("--robin", text);
  const RobinValues values = robin_values(a);
  return {part(mesh, a, false), values.alpha, values.outside};
}

// A name and a tag may stand for the same group.
void check_given_once(const std::vector<Dirichlet>& before, const BoundaryPart& part,
                      const Assignment& a) {
  for (const Dirichlet& one : before) {
    if (one.part.curves != part.curves || one.part.points != part.points) continue;
    throw InputError(a.where, "this group already has a value, by --dirichlet " + one.part.name,
                     "give each group one");
  }
}

}  // namespace

void check_form(const GroupOptions& options) {
  for (const std::string& text : options.diffusion) {
    const Assignment a = split("--diffusion", text);
    positive(a, a.value);
  }
  for (const std::string& text : options.robin) robin_values(split("--robin", text));
  const auto check_linear = [](const char* option, const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
      const Assignment a = split(option, text);
      linear(a, a.value);
    }
  };
  check_linear("--source", options.source);
  check_linear("--dirichlet", options.dirichlet);
  check_linear("--neumann", options.neumann);
}

PoissonProblem problem_from(const GroupOptions& options, const Mesh& mesh) {
  PoissonProblem problem;
  problem.diffusion = diffusion_from(options.diffusion, mesh);
  problem.source = source_from(options.source, mesh);
  for (const std::string& text : options.dirichlet) {
    const Assignment a = split("--dirichlet", text);
    const BoundaryPart where = part(mesh, a, true);
    check_given_once(problem.dirichlet, where, a);
    problem.dirichlet.push_back({where, linear(a, a.value)});
  }
  for (const std::string& text : options.neumann) {
    const Assignment a = split("--neumann", text);
    problem.neumann.push_back({part(mesh, a, false), linear(a, a.value)});
  }
  for (const std::string& text : options.robin) {
    problem.robin.push_back(robin_from(text, mesh));
  }
  return problem;
}

}  // namespace lepp::demo
