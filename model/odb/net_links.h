#pragma once

#include <vector>

#include "model/document_builder.h"
#include "model/odb/step.h"

namespace model::odb {

/// Which net each feature of a step belongs to, by the FID records of eda/data (odb-notes, Stack). `$NONE$` is no net.
class NetLinks {
public:
    NetLinks(DocumentBuilder& builder, const Matrix& matrix, const StepData& step);

    /// By feature of that layer (row of the matrix); empty when none of them has a net.
    [[nodiscard]] const std::vector<NetId>& netsOf(std::size_t layer) const { return m_features[layer]; }
    /// The net a component pin names by number; none if there is no such net.
    [[nodiscard]] NetId net(std::int32_t number) const;

private:
    void link(const Matrix& matrix, const StepData& step, Diagnostics& diagnostics);

    std::vector<NetId> m_nets;                   ///< by number of the NET record
    std::vector<std::vector<NetId>> m_features;  ///< by layer and feature
};

}  // namespace model::odb
