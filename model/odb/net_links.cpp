#include "model/odb/net_links.h"

#include "model/odb/records.h"

namespace model::odb {

namespace {

/// Row of the matrix for each layer of a LYR line; the number of rows for unknown ones.
std::vector<std::size_t> matrixRows(const Matrix& matrix, const EdaData& eda) {
    std::vector<std::size_t> rows;
    for (const std::string& name : eda.layers) {
        std::size_t row = 0;
        while (row < matrix.layers.size() && !equalsIgnoringCase(matrix.layers[row].name, name)) {
            ++row;
        }
        rows.push_back(row);
    }
    return rows;
}

}  // namespace

NetLinks::NetLinks(DocumentBuilder& builder, const Matrix& matrix, const StepData& step)
    : m_features(matrix.layers.size()) {
    for (const std::string& name : step.eda.value.nets) {
        m_nets.push_back(name == kNoNet ? NetId{} : builder.addNet(name));
    }
    link(matrix, step, builder.diagnostics());
}

void NetLinks::link(const Matrix& matrix, const StepData& step, Diagnostics& diagnostics) {
    const EdaData& eda = step.eda.value;
    const std::vector<std::size_t> layers = matrixRows(matrix, eda);
    for (const NetFeature& record : eda.netFeatures) {
        const std::size_t layer = layers[record.layer];
        if (layer == matrix.layers.size()) {
            diagnostics.report(Severity::Warning, step.eda.path, record.line,
                               "FID: layer " + eda.layers[record.layer] + " is not in the matrix");
            continue;
        }
        const std::size_t count = step.layers[layer].features.value.features.size();
        if (record.feature >= count) {
            diagnostics.report(Severity::Warning, step.eda.path, record.line,
                               "FID: layer " + eda.layers[record.layer] + " has no feature of that number");
            continue;
        }
        m_features[layer].resize(count);
        m_features[layer][record.feature] = m_nets[record.net];
    }
}

NetId NetLinks::net(std::int32_t number) const {
    return number >= 0 && static_cast<std::size_t>(number) < m_nets.size() ? m_nets[static_cast<std::size_t>(number)]
                                                                           : NetId{};
}

}  // namespace model::odb
