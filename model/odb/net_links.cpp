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

NetLinks::NetLinks(DocumentBuilder& builder, const Matrix& matrix, const Steps& steps)
    : m_nets(steps.size()), m_features(steps.size()) {
    for (std::size_t step = 0; step < steps.size(); ++step) {
        m_features[step].resize(matrix.layers.size());
        addNets(builder, steps[step].eda.value, step);
        link(builder, matrix, steps[step], step);
    }
}

void NetLinks::addNets(DocumentBuilder& builder, const EdaData& eda, std::size_t step) {
    std::unordered_map<std::string, NetId> own;
    for (const std::string& name : eda.nets) {
        NetId id;
        if (name != kNoNet) {
            const auto shared = m_netOfName.find(name);
            id = shared != m_netOfName.end() ? shared->second : builder.addNet(name);
            own.try_emplace(name, id);
        }
        m_nets[step].push_back(id);
    }
    // Only nets of other steps are shared by name.
    m_netOfName.merge(own);
}

void NetLinks::link(DocumentBuilder& builder, const Matrix& matrix, const StepData& step, std::size_t row) {
    const EdaData& eda = step.eda.value;
    const std::vector<std::size_t> layers = matrixRows(matrix, eda);
    for (const NetFeature& record : eda.netFeatures) {
        const std::size_t layer = layers[record.layer];
        if (layer == matrix.layers.size()) {
            builder.diagnostics().report(Severity::Warning, step.eda.path, record.line,
                                         "FID: layer " + eda.layers[record.layer] + " is not in the matrix");
            continue;
        }
        const std::size_t count = step.layers[layer].features.value.features.size();
        if (record.feature >= count) {
            builder.diagnostics().report(Severity::Warning, step.eda.path, record.line,
                                         "FID: layer " + eda.layers[record.layer] + " has no feature of that number");
            continue;
        }
        m_features[row][layer].resize(count);
        m_features[row][layer][record.feature] = m_nets[row][record.net];
    }
}

NetId NetLinks::net(std::size_t step, std::int32_t number) const {
    const std::vector<NetId>& nets = m_nets[step];
    return number >= 0 && static_cast<std::size_t>(number) < nets.size() ? nets[static_cast<std::size_t>(number)]
                                                                         : NetId{};
}

}  // namespace model::odb
