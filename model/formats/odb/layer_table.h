#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/board/document_builder.h"
#include "model/formats/odb/steps/step.h"

namespace model::odb {

/// Brings the rows of the matrix into the document: in physical order, with their spans, heights and thicknesses. There
/// is one stackup for all steps of a panel: where the first step is silent about a layer, the next one counts. Rows
/// without files are reported.
class LayerTable {
public:
    LayerTable(const JobContext& job, const Steps& steps, DocumentBuilder& builder);

    /// `boardNm` is the job's own board thickness, if it has one.
    void add(std::optional<double> boardNm);

    /// Rows of the matrix in document order.
    [[nodiscard]] const std::vector<std::size_t>& order() const { return m_order; }
    [[nodiscard]] LayerId id(std::size_t row) const { return m_layerOfRow[row]; }
    /// Row of the matrix for a layer; documents list the rows in `order()`.
    [[nodiscard]] std::size_t rowOf(LayerId id) const { return m_order[id.row()]; }
    /// Adds the same layers to the document of another step, which has files of its own.
    void copyTo(DocumentBuilder& builder, const StepData& step) const;

private:
    void addLayers();
    [[nodiscard]] LayerFacts factsOf(std::size_t row) const;
    [[nodiscard]] bool isEmptyMaterial(std::size_t row) const;
    void leaveOut(std::vector<LayerFacts>& facts);
    void reportMissing(std::size_t row);
    void reportEmptyLayers();
    void reportUnread();
    [[nodiscard]] bool isRepeatedName(std::size_t row) const;
    [[nodiscard]] std::vector<LayerId> copperLayers() const;
    void setSpans();
    [[nodiscard]] LayerId spanEnd(const std::vector<LayerId>& copper, std::size_t row, const std::string& name,
                                  LayerId otherwise) const;
    void addStackup(std::optional<double> boardNm);
    void compareWithStep(const Stackup& stackup, std::optional<double> stepNm, const std::string& path);
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
