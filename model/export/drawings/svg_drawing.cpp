#include "model/export/drawings/svg_drawing.h"

#include <numbers>

#include "model/export/drawings/drawing_paths.h"
#include "model/text/formatting.h"

namespace model {

namespace {

constexpr const char* kLineWidth = "0.1";  // mm
/// Nearer to a half turn, the centre would depend on the last digit of both ends.
constexpr double kMostSweep = 2 * std::numbers::pi / 3;

class SvgForm : public DrawingForm {
public:
    SvgForm(FileWriter& file, Nm margin) : m_file(file), m_margin(margin) {}

    void begin(const Drawing& drawing) override {
        const Box page = drawing.box.grownBy(m_margin);
        m_left = page.min.x;
        m_top = page.max.y;
        std::string width;
        std::string height;
        appendMm(width, static_cast<double>(page.width()));
        appendMm(height, static_cast<double>(page.height()));
        m_file.write("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
                     width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width + ' ' + height + "\">\n");
        m_file.write("<title>" + xmlText(drawing.title) + "</title>\n");
    }

    void beginLayer(const DrawnLayer& layer) override {
        m_colour = formatted("#%06x", layer.colour & 0xFFFFFFU);
        const std::string filled = "fill=\"" + m_colour + "\" fill-rule=\"evenodd\"";
        const std::string contour = "fill=\"none\" stroke=\"" + m_colour + "\" stroke-width=\"" + kLineWidth + '"';
        m_filled = layer.hasContours ? filled + " stroke=\"none\" " : "";
        m_file.write("<g id=\"layer-" + (layer.layer.isValid() ? std::to_string(layer.layer.row() + 1) : "outline") +
                     "\" " + (layer.hasContours ? contour : filled) + ">\n<title>" + xmlText(layer.name) +
                     "</title>\n");
    }

    void addRegion(const EdgeLoops& region, RegionPaint paint) override {
        m_path = "<path " + (paint == RegionPaint::Filled ? m_filled : "") + "d=\"";
        for (std::size_t i = 0; i < region.loopCount(); ++i) {
            addLoop(region.loop(i));
        }
        m_path += "\"/>\n";
        m_file.write(m_path);
    }

    void addName(const DrawnName& name) override {
        std::string x;
        std::string middle;
        std::string baseline;
        std::string size;
        appendMm(x, name.centre.x - m_left);
        appendMm(middle, m_top - name.centre.y);
        appendMm(baseline, m_top - name.centre.y + kNameBaseline * name.height);
        appendMm(size, name.height);
        const std::string turn = name.isUpright ? "\" transform=\"rotate(-90 " + x + ' ' + middle + ')' : "";
        m_file.write("<text x=\"" + x + "\" y=\"" + baseline + "\" font-family=\"sans-serif\" font-size=\"" + size +
                     "\" text-anchor=\"middle\" fill=\"" + m_colour + "\" stroke=\"none" + turn + "\">" +
                     xmlText(name.text) + "</text>\n");
    }

    void endLayer() override { m_file.write("</g>\n"); }
    void end() override { m_file.write("</svg>\n"); }

private:
    void addPoint(PointD p) {
        appendMm(m_path, p.x - m_left);
        m_path += ' ';
        appendMm(m_path, m_top - p.y);
    }

    void addLoop(std::span<const Edge> loop) {
        m_path += 'M';
        addPoint(loop.front().a);
        for (const Edge& edge : loop) {
            for (const Edge& piece : shortPiecesOf(edge, kMostSweep)) {
                addEdge(piece);
            }
        }
        m_path += 'Z';
    }

    void addEdge(const Edge& edge) {
        if (edge.isArc()) {
            std::string radius;
            appendMm(radius, edge.radius);
            // What runs clockwise on the board does so in the picture.
            m_path += 'A' + radius + ' ' + radius + (edge.isClockwise ? " 0 0 1 " : " 0 0 0 ");
        } else {
            m_path += 'L';
        }
        addPoint(edge.b);
    }

    FileWriter& m_file;
    Nm m_margin;
    double m_left = 0.0;
    double m_top = 0.0;
    std::string m_colour;  ///< of the layer, "#rrggbb"
    std::string m_filled;  ///< says of a path that it is filled, where its layer has contours
    std::string m_path;
};

}  // namespace

base::Result<DrawingReport> writeSvg(const Document& board, const DrawingOptions& options, FileWriter& file,
                                     base::Progress& progress) {
    SvgForm form(file, options.margin);
    return drawLayers(board, options, DrawingOrder::BottomFirst, form, file, progress);
}

}  // namespace model
