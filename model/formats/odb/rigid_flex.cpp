#include "model/formats/odb/rigid_flex.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "model/formats/odb/features/features.h"
#include "model/formats/odb/text/records.h"
#include "model/formats/steps/zone_outlines.h"
#include "model/geometry/region.h"

namespace model::odb {

namespace {

std::size_t rowOfNumber(const Matrix& matrix, std::int64_t number) {
    const auto found = std::ranges::find(matrix.layers, number, &MatrixLayer::row);
    return static_cast<std::size_t>(found - matrix.layers.begin());
}

/// The rows that the numbers are when `shift` is added to them, those of all zones one after the other.
std::vector<std::size_t> rowsOfNumbers(const ZoneFile& file, const Matrix& matrix, std::int64_t shift) {
    std::vector<std::size_t> rows;
    for (const ZoneRecord& zone : file.zones) {
        for (const std::string& word : zone.layers) {
            const auto number = parseInteger(word);
            const std::size_t row = number ? rowOfNumber(matrix, *number + shift) : matrix.layers.size();
            if (row < matrix.layers.size()) {
                rows.push_back(row);
            }
        }
    }
    return rows;
}

/// How well numbers with `shift` added to them fit the matrix: how many are layers of the stackup, and then how much
/// copper is in a zone.
std::pair<std::size_t, std::size_t> fit(const ZoneFile& file, const Matrix& matrix, std::int64_t shift) {
    const std::vector<std::size_t> rows = rowsOfNumbers(file, matrix, shift);
    const auto inStack = std::ranges::count_if(rows, [&](std::size_t row) { return isPhysical(matrix.layers[row]); });
    std::set<std::size_t> copper;
    std::ranges::copy_if(rows, std::inserter(copper, copper.end()), [&](std::size_t row) {
        return matrix.layers[row].isCopper() && isPhysical(matrix.layers[row]);
    });
    return {static_cast<std::size_t>(inStack), copper.size()};
}

/// Which zones with an outline have the layer, one letter for each; empty if all or none have it: it is bounded by
/// none of them.
std::string zonesWith(const ZoneFile& file, const ZoneRows& zones, std::size_t row) {
    std::string key;
    for (std::size_t i = 0; i < file.zones.size(); ++i) {
        if (file.zones[i].outline.isValid()) {
            key += std::ranges::binary_search(zones.rows[i], row) ? '1' : '0';
        }
    }
    const bool isMixed = key.find('0') != std::string::npos && key.find('1') != std::string::npos;
    return isMixed ? key : "";
}

/// What decides where a layer exists; the same for layers with the same outline, empty for the board's.
std::string outlineKey(const StepData& step, const ZoneRows& zones, const Matrix& matrix, std::size_t row) {
    if (step.layers[row].profile.isPresent()) {
        return "row " + std::to_string(row);
    }
    return isPhysical(matrix.layers[row]) ? zonesWith(step.zones.value, zones, row) : "";
}

/// Gives the layers of one step their outlines.
class OutlineMaker {
public:
    OutlineMaker(DocumentBuilder& builder, const Matrix& matrix, const LayerTable& layers, const StepData& step)
        : m_builder(builder),
          m_matrix(matrix),
          m_layers(layers),
          m_step(step),
          m_file(step.zones.value),
          m_zones(rowsOfZones(m_file, matrix)),
          m_outlines(builder) {}

    void run() {
        addZones();
        for (const std::size_t row : m_layers.order()) {
            m_builder.layer(m_layers.id(row)).profile = outlineOf(row);
        }
        reportUnbounded();
    }

private:
    void report(Severity severity, std::uint32_t line, std::string_view text) {
        m_builder.diagnostics().report(severity, m_step.zones.path, line, text);
    }

    void addZones() {
        for (std::size_t i = 0; i < m_file.zones.size(); ++i) {
            const ZoneRecord& from = m_file.zones[i];
            Zone zone;
            zone.name = from.name;
            for (const std::size_t row : m_zones.rows[i]) {
                zone.layers.push_back(m_layers.id(row));
            }
            std::ranges::sort(zone.layers);
            if (from.outline.isValid()) {
                zone.shape = m_builder.addShape(sketchOf(m_file.outlines, from.outline));
            } else {
                report(Severity::Warning, from.line, "a zone without an outline bounds no layers");
            }
            m_builder.addZone(std::move(zone));
        }
        for (const std::uint32_t line : m_zones.unknown) {
            report(Severity::Warning, line, "a zone names a layer that is not in the matrix");
        }
        if (m_zones.hasNumbers) {
            report(Severity::Info, 0,
                   m_zones.countsFromZero ? "the zones count the rows of the matrix from 0"
                                          : "the zones count the rows of the matrix from 1");
        }
    }

    ShapeId outlineOf(std::size_t row) {
        const Parsed<FeatureFile>& own = m_step.layers[row].profile;
        if (const std::optional<ShapeSketch> sketch = profileOf(own.value)) {
            return m_builder.addShape(*sketch);
        }
        if (own.isPresent()) {
            m_builder.diagnostics().report(Severity::Warning, own.path, 0,
                                           "the layer's profile holds no outline; the board's is used");
            return {};
        }
        return isPhysical(m_matrix.layers[row]) ? m_outlines.of(m_layers.id(row)) : ShapeId{};
    }

    /// Copper and dielectrics that no zone has.
    void reportUnbounded() {
        std::string names;
        for (const std::size_t row : m_layers.order()) {
            const MatrixLayer& layer = m_matrix.layers[row];
            const bool isStack = layer.isCopper() || layer.type == LayerType::Dielectric;
            const auto has = [row](const std::vector<std::size_t>& rows) {
                return std::ranges::binary_search(rows, row);
            };
            if (isStack && isPhysical(layer) && std::ranges::none_of(m_zones.rows, has)) {
                names += (names.empty() ? "" : ", ") + layer.name;
            }
        }
        if (!m_file.zones.empty() && !names.empty()) {
            report(Severity::Warning, 0, "layers that no zone has are taken to be all over the board: " + names);
        }
    }

    DocumentBuilder& m_builder;
    const Matrix& m_matrix;
    const LayerTable& m_layers;
    const StepData& m_step;
    const ZoneFile& m_file;
    ZoneRows m_zones;
    formats::ZoneOutlines m_outlines;
};

}  // namespace

ZoneRows rowsOfZones(const ZoneFile& file, const Matrix& matrix) {
    ZoneRows result;
    result.countsFromZero = fit(file, matrix, 1) >= fit(file, matrix, 0);
    for (const ZoneRecord& zone : file.zones) {
        std::vector<std::size_t>& rows = result.rows.emplace_back();
        for (const std::string& word : zone.layers) {
            const auto number = parseInteger(word);
            result.hasNumbers = result.hasNumbers || number.has_value();
            const std::int64_t shifted = std::int64_t{number.value_or(0)} + (result.countsFromZero ? 1 : 0);
            const std::size_t row = number ? rowOfNumber(matrix, shifted) : matrix.rowOf(word);
            row < matrix.layers.size() ? rows.push_back(row) : result.unknown.push_back(zone.line);
        }
        std::ranges::sort(rows);
        rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    }
    return result;
}

std::vector<std::uint32_t> outlineGroups(const Steps& steps, const Matrix& matrix) {
    std::vector<std::string> keys(matrix.layers.size());
    for (const StepData& step : steps) {
        const ZoneRows zones = rowsOfZones(step.zones.value, matrix);
        for (std::size_t row = 0; row < keys.size(); ++row) {
            keys[row] += outlineKey(step, zones, matrix, row) + "|";
        }
    }
    std::ranges::replace(keys, std::string(steps.size(), '|'), std::string());
    return formats::outlineGroups(keys);
}

void addOutlines(DocumentBuilder& builder, const Matrix& matrix, const LayerTable& layers, const StepData& step) {
    OutlineMaker(builder, matrix, layers, step).run();
}

}  // namespace model::odb
