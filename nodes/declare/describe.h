#pragma once
// makeNode: turns `struct In`, `struct Out`, describe() and evaluate() of one file into a NodeType. Typed
// member pointers, so that a misspelt parameter is a compile error.
#include <cmath>
#include <utility>

#include "nodes/declare/eval_context.h"
#include "nodes/declare/node_type.h"
#include "nodes/declare/value_traits.h"

namespace pileus::nodes {

/// Chained refinements of one parameter.
class ParamRow {
 public:
  explicit ParamRow(ParamSpec& spec) : spec_(&spec) {}
  ParamRow& label(std::string v) { return spec_->label = std::move(v), *this; }
  ParamRow& unit(std::string v) { return spec_->unit = std::move(v), *this; }
  ParamRow& help(std::string v) { return spec_->help = std::move(v), *this; }
  /// Hard range; also the soft one unless given.
  ParamRow& range(double lo, double hi) {
    spec_->hardMin = lo, spec_->hardMax = hi;
    if (spec_->softMin == spec_->softMax) spec_->softMin = lo, spec_->softMax = hi;
    return *this;
  }
  ParamRow& soft(double lo, double hi) { return spec_->softMin = lo, spec_->softMax = hi, *this; }
  ParamRow& logarithmic() { return spec_->logarithmic = true, *this; }
  /// Curve and Ramp: 0 .. 1 stands for densities at `input` between two other parameters.
  ParamRow& over(std::string input, std::string lowest, std::string highest, std::string what = "density") {
    return spec_->data = {std::move(input), std::move(lowest), std::move(highest), std::move(what)}, *this;
  }
  /// Instead of all of the enum's, in its words.
  ParamRow& choices(std::vector<Choice> v) { return spec_->choices = std::move(v), *this; }
  ParamRow& socket() { return spec_->socket = true, *this; }
  /// For the editor alone: another value makes nothing anew.
  ParamRow& forEditor() { return spec_->forEditor = true, *this; }
  ParamRow& file(std::vector<std::string> kinds, bool writes = false) {
    return spec_->fileKinds = std::move(kinds), spec_->writes = writes, *this;
  }

 private:
  ParamSpec* spec_;
};

/// Chained refinements of one socket.
class SocketRow {
 public:
  explicit SocketRow(SocketSpec& spec) : spec_(&spec) {}
  SocketRow& label(std::string v) { return spec_->label = std::move(v), *this; }
  SocketRow& help(std::string v) { return spec_->help = std::move(v), *this; }
  SocketRow& many() { return spec_->many = true, *this; }
  SocketRow& required() { return spec_->required = true, *this; }

 private:
  SocketSpec* spec_;
};

/// "step_scale" -> "Step scale", "color" -> "Colour".
std::string labelFromId(std::string_view id);

namespace detail {

/// A member, or a member of a member.
template <class T, class... Path>
auto& memberOf(T& of, Path... path) {
  return (of.*....*path);
}
template <class T, class... Path>
using Member = std::remove_reference_t<decltype(memberOf(std::declval<T&>(), std::declval<Path>()...))>;

SocketSpec& addSocket(std::vector<SocketSpec>& sockets, std::string id, SocketType type);
ParamSpec& addParam(std::vector<ParamSpec>& params, std::string id, ParamType type);

/// How the members of a type's `In` and `Out` are written and read.
struct Members {
  explicit Members(const NodeType& type);
  /// What is linked and set, into an In.
  void fill(void* in, std::span<const std::vector<SocketValue>> inputs,
            std::span<const ParamValue> params) const;
  /// What an Out gives, socket by socket.
  std::vector<SocketValue> given(const void* out) const;

  std::vector<std::function<void(void*, const SocketValue&)>> assign;
  std::vector<std::function<void(void*, const ParamValue&)>> set;
  std::vector<std::function<SocketValue(const void*)>> read;
};

}  // namespace detail

template <class In, class Out>
class Describe {
 public:
  Describe(NodeType& type, const In& defaults) : type_(&type), defaults_(&defaults) {
    // Rows hand out references into these.
    type.params.reserve(64);
    type.inputs.reserve(32);
    type.outputs.reserve(32);
  }
  Describe& name(std::string v) { return type_->label = std::move(v), *this; }
  Describe& category(std::string v) { return type_->category = std::move(v), *this; }
  Describe& help(std::string v) { return type_->help = std::move(v), *this; }
  Describe& keywords(std::string v) { return type_->keywords = std::move(v), *this; }
  Describe& uses(unsigned bits) { return type_->uses |= bits, *this; }
  Describe& output() { return type_->isOutput = true, *this; }

  /// A member of In, or a member of that (`&In::spec, &Spec::filter`): a parameter, whose default is what the
  /// node's `defaults` hold there, or a socket, if its type only flows along links.
  template <class... Path>
  auto in(std::string id, Path... path) {
    using M = detail::Member<In, Path...>;
    using Traits = ValueTraits<M>;
    if constexpr (!Traits::isParam) {
      SocketSpec& s = detail::addSocket(type_->inputs, std::move(id), Traits::socket);
      s.assign = [path...](void* in, const SocketValue& v) {
        if (const M* given = std::get_if<M>(&v))
          Traits::join(detail::memberOf(*static_cast<In*>(in), path...), *given);
      };
      return SocketRow(s);
    } else {
      ParamSpec& p = detail::addParam(type_->params, std::move(id), Traits::param);
      if constexpr (DescribedEnum<M>)
        for (const auto& item : enumInfo(static_cast<M*>(nullptr)))
          p.choices.push_back({std::string(item.id), std::string(item.label), std::string(item.help)});
      p.get = [path...](const void* in) {
        return Traits::kept(detail::memberOf(*static_cast<const In*>(in), path...));
      };
      p.fallback = p.get(defaults_);
      p.set = [path...](void* in, const ParamValue& v) {
        Traits::take(detail::memberOf(*static_cast<In*>(in), path...), v);
      };
      return ParamRow(p);
    }
  }

  template <class M>
  SocketRow out(std::string id, M Out::*member) {
    SocketSpec& s = detail::addSocket(type_->outputs, std::move(id), ValueTraits<M>::socket);
    s.read = [member](const void* out) -> SocketValue { return static_cast<const Out*>(out)->*member; };
    return SocketRow(s);
  }

 private:
  NodeType* type_;
  const In* defaults_;
};

/// A node of one type begins with `defaults`, whose members are the parameters' defaults.
template <class In, class Out>
NodeType makeNode(std::string id, int version, void (*describe)(Describe<In, Out>&),
                  Result<Out> (*evaluate)(const In&, EvalContext&), In defaults = {}) {
  NodeType type;
  type.id = std::move(id);
  type.version = version;
  Describe<In, Out> d(type, defaults);
  describe(d);
  type.defaults = defaults;
  type.evaluate = [evaluate, defaults = std::move(defaults), members = detail::Members(type)](
                      std::span<const std::vector<SocketValue>> inputs, std::span<const ParamValue> params,
                      EvalContext& context) -> Result<std::vector<SocketValue>> {
    In in = defaults;
    members.fill(&in, inputs, params);
    PILEUS_TRY(Out out, evaluate(in, context));
    return members.given(&out);
  };
  return type;
}

}  // namespace pileus::nodes
