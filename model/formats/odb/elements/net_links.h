#pragma once

#include <vector>

#include "model/board/document_builder.h"
#include "model/formats/odb/steps/step.h"

namespace model::odb {

/// What a feature is in the nets: `net` may be there without a subnet, never a subnet without it.
struct NetLink {
    NetId net;
    SubnetId subnet;
    bool isOfPin = false;  ///< a TOP subnet has it, of `$NONE$` too: it is copper of a pin, whatever it is drawn as
    constexpr bool operator==(const NetLink&) const = default;
};

/// Nets and subnets of a step, and which of them each feature belongs to, by the FID records of eda/data (odb-notes,
/// Nets and parts). `$NONE$` is no net. A feature that several nets claim stays in the first one; that is reported.
class NetLinks {
public:
    NetLinks(DocumentBuilder& builder, const Matrix& matrix, const StepData& step);

    /// By feature of that layer (row of the matrix); empty when none of them has a net.
    [[nodiscard]] const std::vector<NetLink>& linksOf(std::size_t layer) const { return m_features[layer]; }
    /// The net a component pin names by number; none if there is no such net.
    [[nodiscard]] NetId net(std::int32_t number) const;
    /// Subnet of the document for each of eda/data; none for those of `$NONE$`.
    [[nodiscard]] const std::vector<SubnetId>& subnets() const { return m_subnets; }

private:
    void addNets(DocumentBuilder& builder, const EdaData& eda);
    void link(const Matrix& matrix, const StepData& step, Diagnostics& diagnostics);

    std::vector<NetId> m_nets;                     ///< by number of the NET record
    std::vector<SubnetId> m_subnets;               ///< by row of EdaData::subnets
    std::vector<std::vector<NetLink>> m_features;  ///< by layer and feature
};

/// Where the features that eda/data names are: by row of EdaData::layers, the row of the matrix; the number of rows for
/// layers that are not in it.
[[nodiscard]] std::vector<std::size_t> matrixRows(const Matrix& matrix, const EdaData& eda);

/// Interned copies of what a parser read.
[[nodiscard]] Range addProperties(DocumentBuilder& builder, const std::vector<TextProperty>& properties);

}  // namespace model::odb
