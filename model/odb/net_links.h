#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "model/document_builder.h"
#include "model/odb/step.h"

namespace model::odb {

/// Which net each feature of each step belongs to, by the FID records of eda/data (odb-notes, Stack). Nets of one name
/// in several steps of a panel are one net. `$NONE$` is no net.
class NetLinks {
public:
    NetLinks(DocumentBuilder& builder, const Matrix& matrix, const Steps& steps);

    /// By feature of that step's layer; empty when none of them has a net.
    [[nodiscard]] const std::vector<NetId>& netsOf(std::size_t step, std::size_t layer) const {
        return m_features[step][layer];
    }
    /// The net a component pin of the step names by number; none if there is no such net.
    [[nodiscard]] NetId net(std::size_t step, std::int32_t number) const;

private:
    void addNets(DocumentBuilder& builder, const EdaData& eda, std::size_t step);
    void link(DocumentBuilder& builder, const Matrix& matrix, const StepData& step, std::size_t row);

    std::unordered_map<std::string, NetId> m_netOfName;
    std::vector<std::vector<NetId>> m_nets;                   ///< by step and number of the NET record
    std::vector<std::vector<std::vector<NetId>>> m_features;  ///< by step, layer and feature
};

}  // namespace model::odb
