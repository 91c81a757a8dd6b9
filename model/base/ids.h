#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace base {

/// A 32-bit row number in one table. The tag makes mixing up two tables a compile error; the value is what travels to
/// the GPU, into picking and into reports. A default-made id is "none".
template <class Tag>
struct Id {
    static constexpr std::uint32_t kNone = 0xffffffffu;

    std::uint32_t value = kNone;

    constexpr Id() = default;
    constexpr explicit Id(std::size_t row) : value(static_cast<std::uint32_t>(row)) {}

    [[nodiscard]] constexpr bool isValid() const { return value != kNone; }
    [[nodiscard]] constexpr std::size_t row() const { return value; }
    constexpr auto operator<=>(const Id&) const = default;
};

}  // namespace base

namespace model {

using ElementId = base::Id<struct ElementTag>;
using LayerId = base::Id<struct LayerTag>;
using NetId = base::Id<struct NetTag>;
using ComponentId = base::Id<struct ComponentTag>;
using SymbolId = base::Id<struct SymbolTag>;
using ShapeId = base::Id<struct ShapeTag>;
using PackageId = base::Id<struct PackageTag>;
using PinId = base::Id<struct PinTag>;
using StringId = base::Id<struct StringTag>;
using SubnetId = base::Id<struct SubnetTag>;

}  // namespace model

template <class Tag>
struct std::hash<base::Id<Tag>> {
    std::size_t operator()(base::Id<Tag> id) const noexcept { return std::hash<std::uint32_t>{}(id.value); }
};
