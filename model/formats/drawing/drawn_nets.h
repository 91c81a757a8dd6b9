#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "model/board/document_builder.h"
#include "model/formats/drawing/drawn_job.h"

namespace model::formats {

/// What a feature is in the nets: `net` may be there without a subnet, never a subnet without it.
struct DrawnLink {
    NetId net;
    SubnetId subnet;
};

/// The nets of a step and their subnets, which are made as features name them: one for each pin, one for the via at a
/// location, one for the planes of a net on a layer, one for its traces and one for all else.
class DrawnNets {
public:
    /// Adds the nets to the builder. Both must stay where they are.
    DrawnNets(DocumentBuilder& builder, const DrawnStep& step);

    [[nodiscard]] NetId net(std::int32_t row) const;
    /// Of a feature on that layer; what names a net or pin that is not there has none. The components of the step must
    /// be in the builder.
    [[nodiscard]] DrawnLink linkOf(const DrawnFeature& feature, LayerId layer);

private:
    /// Net, kind, and two numbers that tell subnets of that kind apart.
    using Key = std::array<std::uint32_t, 4>;
    struct KeyHash {
        std::size_t operator()(const Key& key) const noexcept;
    };

    [[nodiscard]] PinId pinOf(const DrawnFeature& feature) const;
    [[nodiscard]] static Key keyOf(const DrawnFeature& feature, NetId net, PinId pin, LayerId layer);

    DocumentBuilder& m_builder;
    std::vector<NetId> m_nets;
    std::unordered_map<Key, SubnetId, KeyHash> m_subnets;
};

/// Interned copies of names and values.
[[nodiscard]] Range addProperties(DocumentBuilder& builder, const Words& words);

}  // namespace model::formats
