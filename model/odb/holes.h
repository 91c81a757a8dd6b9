#pragma once

#include <string>
#include <vector>

#include "model/odb/features.h"
#include "model/odb/tools.h"

namespace model::odb {

/// How thick the copper in a plated hole is taken to be: 25 µm, the usual class 2 to 3 value. The drilled size is the
/// symbol's.
inline constexpr Nm kPlating = 25'000;

/// What makes the features of a drill or rout layer holes: which of them are plated.
class HoleRules {
public:
    HoleRules(LayerType type, std::vector<Tool> tools) : m_type(type), m_tools(std::move(tools)) {}

    /// By the feature's .drill attribute, else by the tools of that size or of the whole layer, else by the layer:
    /// drills are plated, routs are not. `isAssumed` is set in the last case.
    [[nodiscard]] bool isPlated(const Feature& feature, Nm size, bool& isAssumed) const;
    /// A rout path is one long hole; each stroke of a drill layer is a slot of its own.
    [[nodiscard]] bool joinsStrokes() const { return m_type == LayerType::Rout; }
    /// Width of what is left open in a hole of `size`: the copper takes kPlating from each side, or half of the hole if
    /// it is smaller than that.
    [[nodiscard]] static Nm openSize(Nm size, bool isPlated);

private:
    LayerType m_type;
    std::vector<Tool> m_tools;
};

}  // namespace model::odb
