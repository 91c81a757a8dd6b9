#include "model/formats/odb/elements/net_links.h"

namespace model::odb {

std::vector<std::size_t> matrixRows(const Matrix& matrix, const EdaData& eda) {
    std::vector<std::size_t> rows;
    for (const std::string& name : eda.layers) {
        rows.push_back(matrix.rowOf(name));
    }
    return rows;
}

Range addProperties(DocumentBuilder& builder, const std::vector<TextProperty>& properties) {
    std::vector<Property> rows;
    rows.reserve(properties.size());
    for (const TextProperty& property : properties) {
        rows.push_back({builder.string(property.name), builder.string(property.value)});
    }
    return builder.addProperties(rows);
}

NetLinks::NetLinks(DocumentBuilder& builder, const Matrix& matrix, const StepData& step)
    : m_features(matrix.layers.size()) {
    addNets(builder, step.eda.value);
    link(matrix, step, builder.diagnostics());
}

void NetLinks::addNets(DocumentBuilder& builder, const EdaData& eda) {
    for (const EdaNet& net : eda.nets) {
        m_nets.push_back(net.name == kNoNet ? NetId{}
                                            : builder.addNet(net.name, addProperties(builder, net.properties)));
    }
    for (const EdaSubnet& from : eda.subnets) {
        Subnet subnet;
        subnet.net = m_nets[from.net];
        subnet.kind = from.kind;
        subnet.planeFill = from.planeFill;
        subnet.planeCutout = from.planeCutout;
        subnet.planeCutoutSize = from.planeCutoutSize;
        m_subnets.push_back(subnet.net.isValid() ? builder.addSubnet(subnet) : SubnetId{});
    }
}

void NetLinks::link(const Matrix& matrix, const StepData& step, Diagnostics& diagnostics) {
    const EdaData& eda = step.eda.value;
    const std::vector<std::size_t> layers = matrixRows(matrix, eda);
    const auto warn = [&](std::uint32_t line, const std::string& text) {
        diagnostics.report(Severity::Warning, step.eda.path, line, text);
    };
    for (std::size_t row = 0; row < eda.subnets.size(); ++row) {
        const EdaSubnet& subnet = eda.subnets[row];
        for (std::uint32_t i = subnet.firstFeature; i < subnet.firstFeature + subnet.featureCount; ++i) {
            const EdaFeature& record = eda.features[i];
            const std::size_t layer = layers[record.layer];
            if (layer == matrix.layers.size()) {
                warn(record.line, "FID: layer " + eda.layers[record.layer] + " is not in the matrix");
                continue;
            }
            const std::size_t count = step.layers[layer].features.value.features.size();
            if (record.feature >= count) {
                warn(record.line, "FID: layer " + eda.layers[record.layer] + " has no feature of that number");
                continue;
            }
            m_features[layer].resize(count);
            NetLink& link = m_features[layer][record.feature];
            const NetLink wanted{m_nets[subnet.net], m_subnets[row], subnet.kind == SubnetKind::PinPads};
            if (link.net.isValid() && link.net != wanted.net) {
                warn(record.line, "FID: the feature is in another net already; it stays there");
                continue;
            }
            link = wanted;
        }
    }
}

NetId NetLinks::net(std::int32_t number) const {
    return number >= 0 && static_cast<std::size_t>(number) < m_nets.size() ? m_nets[static_cast<std::size_t>(number)]
                                                                           : NetId{};
}

}  // namespace model::odb
