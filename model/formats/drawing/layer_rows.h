#pragma once

#include <vector>

#include "model/board/document_builder.h"
#include "model/formats/drawing/drawn_job.h"

namespace model::formats {

/// Brings the layers of a job into its documents: those the board is made of first, as the job lists them from the top,
/// with their spans, heights and thicknesses; all steps have the same.
class LayerRows {
public:
    /// The job must stay where it is.
    LayerRows(const DrawnJob& job, DocumentBuilder& builder);

    /// Adds the layers to the builder, as the first step has them.
    void add();
    /// Adds the same layers to the document of another step.
    void copyTo(DocumentBuilder& builder, std::size_t step) const;

    /// Rows of DrawnJob::layers in document order.
    [[nodiscard]] const std::vector<std::size_t>& order() const { return m_order; }
    [[nodiscard]] LayerId id(std::size_t row) const { return m_layerOfRow[row]; }
    [[nodiscard]] std::size_t rowOf(LayerId id) const { return m_order[id.row()]; }

private:
    [[nodiscard]] Layer layerOf(std::size_t row) const;
    void setSpans();
    [[nodiscard]] LayerId spanEnd(std::size_t row, std::int32_t end, LayerId otherwise) const;
    void addStackup();
    void leaveOut(std::vector<LayerFacts>& facts) const;
    [[nodiscard]] bool isDrawnOn(std::size_t row) const;
    void reportEmptyLayers() const;

    const DrawnJob& m_job;
    DocumentBuilder& m_builder;
    std::vector<std::size_t> m_order;
    std::vector<LayerId> m_layerOfRow;
};

/// What a step draws on a row of DrawnJob::layers.
[[nodiscard]] std::span<const DrawnFeature> featuresOf(const DrawnStep& step, std::size_t row);

/// Is the layer a part of the stackup?
[[nodiscard]] bool isPhysical(const DrawnLayer& layer);

}  // namespace model::formats
