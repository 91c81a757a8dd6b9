#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/board/copies.h"
#include "model/geometry/loops/edge_loops.h"
#include "model/text/file_writer.h"

/// Layers of a board as drawings for others, true to scale: what dxf_drawing.h, svg_drawing.h and pdf_drawing.h have in
/// common. Elements are drawn as designed, those of all copies of steps included; arcs stay arcs. Bodies of components
/// have their designators in them.
namespace model {

struct DrawingOptions {
    std::vector<bool> layers;            ///< by layer of the board: is it drawn? Empty: all but those that we add
    std::vector<std::uint32_t> colours;  ///< by layer of the board, 0xRRGGBB; black where there is none
    bool hasOutline = true;              ///< the outline of the board, and those of copies, as a layer of its own
    std::uint32_t outlineColour = 0;     ///< 0xRRGGBB
    Nm margin = 1'000'000;               ///< of pages and pictures, around what is drawn
};

struct DrawnLayer {
    LayerId layer;  ///< of the board; none: its outline
    std::string name;
    std::uint32_t colour = 0;  ///< 0xRRGGBB
    bool hasContours = false;  ///< areas, which would hide the board under them, as the substrate, are thin lines
    bool isOfBottom = false;   ///< it lies on the bottom of the board
};

/// An element of which nothing is drawn, and why. In panels once, however often its step is placed.
struct NotDrawn {
    std::string layer;
    ElementId element;       ///< of its step
    std::string file;        ///< of the job
    std::uint32_t line = 0;  ///< of that file, from 1
    std::string_view reason;
    std::uint32_t step = 0;  ///< row of model::StepTree::steps
};

struct DrawingReport {
    std::vector<DrawnLayer> layers;  ///< in the order they were written
    std::uint64_t regions = 0;       ///< islands with their holes
    std::vector<NotDrawn> notDrawn;
};

/// What is about to be drawn.
struct Drawing {
    std::string title;               ///< of the job
    std::vector<DrawnLayer> layers;  ///< as in the document, the outline last
    Box box;                         ///< of everything on them
};

enum class RegionPaint : std::uint8_t {
    Filled,
    Contour  ///< a thin line along its edge; only on layers that have contours
};

/// The designator of a component, for its body: one line of letters.
struct DrawnName {
    std::string text;        ///< UTF-8, not empty
    PointD centre;           ///< nm
    double height = 0.0;     ///< of the letters with what is above and below them, nm
    bool isUpright = false;  ///< it reads upwards, else to the right
};
inline constexpr double kNameLetterWidth = 0.6;  ///< of its height; most letters are narrower
inline constexpr double kNameBaseline = 0.36;    ///< below the centre, of its height: capitals are 0.72 high

/// A kind of file. Regions are in the coordinates of the board, nm, y up.
class DrawingForm {
public:
    virtual ~DrawingForm() = default;
    virtual void begin(const Drawing& drawing) = 0;
    virtual void beginLayer(const DrawnLayer& layer) = 0;
    virtual void addRegion(const EdgeLoops& region, RegionPaint paint) = 0;
    virtual void addName(const DrawnName& name) = 0;  ///< legible as the page or picture is seen
    virtual void endLayer() = 0;
    virtual void end() = 0;
};

/// In which order layers are drawn.
enum class DrawingOrder : std::uint8_t {
    AsListed,
    BottomFirst  ///< so that what is above lies above: the lowest first, then holes, then the outline
};

/// Draws the layers with a form that writes into `file`, which is left to be committed. Errors: BadUsage where no layer
/// is left to draw or nothing is on those that are named, OutputFailed, Cancelled.
[[nodiscard]] base::Result<DrawingReport> drawLayers(const Document& board, const DrawingOptions& options,
                                                     DrawingOrder order, DrawingForm& form, const FileWriter& file,
                                                     base::Progress& progress);

}  // namespace model
