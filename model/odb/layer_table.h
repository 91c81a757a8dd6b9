#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/document_builder.h"
#include "model/odb/step.h"

namespace model::odb {

/// Brings the rows of the matrix into the document: in physical order, with their spans, heights and thicknesses. Rows
/// without files are reported.
class LayerTable {
public:
    LayerTable(const JobContext& job, const Steps& steps, DocumentBuilder& builder);

    /// `boardNm` is the job's own board thickness, if it has one.
    void add(std::optional<double> boardNm);

    /// Rows of the matrix in document order.
    [[nodiscard]] const std::vector<std::size_t>& order() const { return m_order; }
    [[nodiscard]] LayerId id(std::size_t row) const { return m_layerOfRow[row]; }
    /// The row in the same place of the stack counted from the bottom. Rows outside of the stack, drills for example,
    /// stay.
    [[nodiscard]] std::size_t oppositeRow(std::size_t row) const;

private:
    void addLayers();
    void describeFeatures(std::size_t row, Layer& layer);
    void reportMissing(std::size_t row, const Layer& layer);
    void reportEmptyLayers();
    void reportUnread();
    [[nodiscard]] bool isRepeatedName(std::size_t row) const;
    [[nodiscard]] std::vector<LayerId> copperLayers() const;
    void setSpans();
    [[nodiscard]] LayerId spanEnd(const std::vector<LayerId>& copper, std::size_t row, const std::string& name,
                                  LayerId otherwise) const;
    void addStackup(std::optional<double> boardNm);
    [[nodiscard]] Diagnostics& diagnostics() const { return m_builder.diagnostics(); }

    const JobContext& m_job;
    const Matrix& m_matrix;
    const Steps& m_steps;
    DocumentBuilder& m_builder;
    std::vector<std::size_t> m_order;
    std::vector<LayerId> m_layerOfRow;
    std::string m_emptyLayers;
};

}  // namespace model::odb
