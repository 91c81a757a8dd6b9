#pragma once

#include <string_view>
#include <unordered_map>
#include <vector>

#include "model/formats/drawing/drawn_job.h"
#include "model/formats/ipc2581/shape_reader.h"
#include "model/formats/ipc2581/specs.h"

namespace model::ipc2581 {

/// A Layer of the file, its spans not yet rows.
struct SourceLayer {
    formats::DrawnLayer drawn;
    std::string_view function;  ///< as the file writes it
    std::string_view from;      ///< names of the layers that end its span; empty: not said
    std::string_view to;
    std::uint32_t line = 0;

    [[nodiscard]] bool isCopper() const {
        return drawn.type == LayerType::Signal || drawn.type == LayerType::PowerGround ||
               drawn.type == LayerType::Mixed;
    }
    [[nodiscard]] bool isHoles() const { return drawn.type == LayerType::Drill || drawn.type == LayerType::Rout; }
    /// Printed or laid on the outside: mask, paste, silkscreen.
    [[nodiscard]] bool isSurface() const;
};

/// The Layers in the order they are written. Rows are indices until `order` sorts them for the document.
class LayerList {
public:
    /// `shapes` draws nothing: it reads the outlines of layers.
    LayerList(Reading& reading, const Specs& specs, ShapeReader& shapes);

    [[nodiscard]] std::size_t size() const { return m_layers.size(); }
    SourceLayer& operator[](std::size_t row) { return m_layers[row]; }
    const SourceLayer& operator[](std::size_t row) const { return m_layers[row]; }
    /// Row of the layer of this name as written; -1 if there is none.
    [[nodiscard]] int find(std::string_view name) const;
    /// The same, with a layer added where there is none.
    std::size_t findOrAdd(std::string_view name, LayerType type, std::uint32_t line);
    /// A layer of drills or routed slots with this span; added, and reported, where there is none.
    std::size_t holesLayer(std::string_view from, std::string_view to, std::uint32_t line);

private:
    void read(XmlCursor& at, const Specs& specs, ShapeReader& shapes);
    void setFunction(SourceLayer& layer);

    Reading& m_reading;
    std::vector<SourceLayer> m_layers;
    std::unordered_map<std::string_view, std::size_t> m_rows;
};

/// Layers of a job as the document wants them: in physical order, with spans as rows. `stack` are the rows of the
/// stackup from the top (stackup_reader.h). Returns the new row of each layer.
[[nodiscard]] std::vector<std::int32_t> orderLayers(Reading& reading, LayerList& layers,
                                                    const std::vector<std::size_t>& stack,
                                                    std::vector<formats::DrawnLayer>& ordered);

}  // namespace model::ipc2581
