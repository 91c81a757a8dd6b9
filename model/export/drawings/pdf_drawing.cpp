#include "model/export/drawings/pdf_drawing.h"

#include <algorithm>

#include "model/base/units.h"
#include "model/export/drawings/drawing_paths.h"
#include "model/export/drawings/paper_colour.h"
#include "model/export/drawings/pdf_file.h"
#include "model/text/number_text.h"

namespace model {

namespace {

constexpr double kPointsPerMm = 72.0 / 25.4;
constexpr int kDigits = 5;          // of a millimetre: 10 nm
constexpr double kCaptionMm = 6.0;  // below a layer
constexpr double kLetterMm = 2.8;
constexpr double kLetterWidth = 0.6;  // of its height; most are narrower

std::string reference(int object) {
    return std::to_string(object) + " 0 R";
}

std::string textOf(double value, int digits) {
    std::string text;
    appendNumber(text, value, digits);
    return text;
}

class PdfForm : public DrawingForm {
public:
    PdfForm(FileWriter& file, Nm margin, PdfPages pages) : m_pdf(file), m_margin(margin), m_pages(pages) {}

    void begin(const Drawing& drawing) override {
        m_title = drawing.title;
        const Box page = drawing.box.grownBy(m_margin);
        m_origin = {static_cast<double>(page.min.x), static_cast<double>(page.min.y)};
        m_width = static_cast<double>(page.width()) / base::kNmPerMm * kPointsPerMm;
        m_height = static_cast<double>(page.height()) / base::kNmPerMm * kPointsPerMm;
        if (m_pages == PdfPages::AllOnOne) {
            beginPage();
            return;
        }
        m_origin.y -= kCaptionMm * base::kNmPerMm;
        m_height += kCaptionMm * kPointsPerMm;
        m_hasOutline = !drawing.layers.empty() && !drawing.layers.back().layer.isValid();
    }

    void beginLayer(const DrawnLayer& layer) override {
        if (m_pages != PdfPages::AllOnOne) {
            beginPage();
        }
        m_layers.push_back({layer.name, m_pdf.reserve(), m_pageObjects.back()});
        m_isOutline = !layer.layer.isValid();
        m_isMirrored = layer.isOfBottom && m_pages == PdfPages::BottomMirrored;
        if (m_isMirrored) {
            m_pdf.addToStream("q -1 0 0 1 " + textOf(m_width / kPointsPerMm, kDigits) + " 0 cm\n");
        }
        const std::uint32_t paint = onPaper(layer.colour);
        const double red = static_cast<double>(paint >> 16U & 0xFFU) / 255.0;
        const double green = static_cast<double>(paint >> 8U & 0xFFU) / 255.0;
        const double blue = static_cast<double>(paint & 0xFFU) / 255.0;
        const std::string colour = textOf(red, 4) + ' ' + textOf(green, 4) + ' ' + textOf(blue, 4);
        m_pdf.addToStream("/OC /L" + std::to_string(m_layers.size()) + " BDC\n" + colour + " rg\n" +
                          (layer.hasContours ? colour + " RG\n" : ""));
    }

    void addRegion(const EdgeLoops& region, RegionPaint paint) override {
        m_path.clear();
        for (std::size_t i = 0; i < region.loopCount(); ++i) {
            addLoop(region.loop(i));
        }
        m_path += paint == RegionPaint::Filled ? "f*\n" : "S\n";
        m_pdf.addToStream(m_path);
        if (m_isOutline && m_hasOutline) {
            m_outline += m_path;
        }
    }

    /// On a page that is mirrored letters are mirrored once more.
    void addName(const DrawnName& name) override {
        const double mirror = m_isMirrored ? -1.0 : 1.0;
        const PointD along = name.isUpright ? PointD{0.0, 1.0} : PointD{mirror, 0.0};
        const PointD up = name.isUpright ? PointD{-mirror, 0.0} : PointD{0.0, 1.0};
        const double half = 0.5 * kNameLetterWidth * static_cast<double>(name.text.size()) * name.height;
        const double below = kNameBaseline * name.height;
        m_path = "BT /Caption " + textOf(name.height / base::kNmPerMm, kDigits) + " Tf ";
        for (const double value : {along.x, along.y, up.x, up.y}) {
            m_path += textOf(value, 0) + ' ';
        }
        addPoint({name.centre.x - half * along.x - below * up.x, name.centre.y - half * along.y - below * up.y});
        m_path += "Tm " + pdfLatin(name.text) + " Tj ET\n";
        m_pdf.addToStream(m_path);
    }

    void endLayer() override {
        m_pdf.addToStream("EMC\n");
        if (m_pages != PdfPages::AllOnOne) {
            if (m_hasOutline && !m_isOutline) {
                m_pdf.addToStream("0.5 G /Outline Do\n");
            }
            if (m_isMirrored) {
                m_pdf.addToStream("Q\n");
            }
            addCaption(m_layers.back().name);
            m_pdf.endStream();
        }
    }

    void end() override {
        if (m_pages == PdfPages::AllOnOne) {
            m_pdf.endStream();
        }
        for (const LayerObject& layer : m_layers) {
            m_pdf.addObject(layer.group, "<< /Type /OCG /Name " + pdfText(layer.name) + " >>");
        }
        writeShared();
        writePages();
        const int catalog = writeCatalog();
        const int info = m_pdf.reserve();
        m_pdf.addObject(info, "<< /Title " + pdfText(m_title) + " /Creator (Copperscope) >>");
        m_pdf.end(catalog, info);
    }

private:
    struct LayerObject {
        std::string name;
        int group = 0;
        int page = 0;
    };

    /// Millimetres from the lower left corner. No board is so large (2.2 m) that its page would need a larger unit.
    void beginPage() {
        m_pageObjects.push_back(m_pdf.reserve());
        m_contents.push_back(m_pdf.reserve());
        m_pdf.beginStream(m_contents.back());
        const std::string scale = textOf(kPointsPerMm, 12);
        m_pdf.addToStream(scale + " 0 0 " + scale + " 0 0 cm\n0.1 w 1 j\n");
    }

    /// In the strip below the layer, as small as it takes to fit.
    void addCaption(const std::string& layer) {
        const std::string text =
            layer + ", " + m_title + (m_isMirrored ? ", seen from the bottom, 1:1" : ", seen from the top, 1:1");
        const double room = m_width / kPointsPerMm - 2.0;
        const double letters = std::min(kLetterMm, room / (kLetterWidth * static_cast<double>(text.size())));
        m_pdf.addToStream("BT 0 g /Caption " + textOf(letters, 3) + " Tf 1 2 Td " + pdfLatin(text) + " Tj ET\n");
    }

    /// What pages share: the font, and the outline on those of layers.
    void writeShared() {
        m_shared =
            " /Font << /Caption << /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >> >>";
        if (m_hasOutline) {
            const int outline = m_pdf.reserve();
            const std::string box =
                textOf(m_width / kPointsPerMm, kDigits) + ' ' + textOf(m_height / kPointsPerMm, kDigits);
            m_pdf.beginStream(outline, "/Type /XObject /Subtype /Form /BBox [0 0 " + box + "] /Resources << >> ");
            m_pdf.addToStream(m_outline);
            m_pdf.endStream();
            m_shared += " /XObject << /Outline " + reference(outline) + " >>";
        }
    }

    void addPoint(PointD p) {
        appendNumber(m_path, (p.x - m_origin.x) / base::kNmPerMm, kDigits);
        m_path += ' ';
        appendNumber(m_path, (p.y - m_origin.y) / base::kNmPerMm, kDigits);
        m_path += ' ';
    }

    void addLoop(std::span<const Edge> loop) {
        addPoint(loop.front().a);
        m_path += "m\n";
        for (const Edge& edge : loop) {
            addEdge(edge);
        }
        m_path += "h\n";
    }

    void addEdge(const Edge& edge) {
        if (!edge.isArc()) {
            addPoint(edge.b);
            m_path += "l\n";
            return;
        }
        for (const Curve& curve : curvesOf(edge)) {
            addPoint(curve.control1);
            addPoint(curve.control2);
            addPoint(curve.b);
            m_path += "c\n";
        }
    }

    [[nodiscard]] std::string layersOf(int page) const {
        std::string text;
        for (std::size_t i = 0; i < m_layers.size(); ++i) {
            if (m_layers[i].page == page) {
                text += "/L" + std::to_string(i + 1) + ' ' + reference(m_layers[i].group) + ' ';
            }
        }
        return text;
    }

    void writePages() {
        m_pageTree = m_pdf.reserve();
        const std::string box = "[0 0 " + textOf(m_width, 6) + ' ' + textOf(m_height, 6) + ']';
        std::string kids;
        for (std::size_t i = 0; i < m_pageObjects.size(); ++i) {
            const int page = m_pageObjects[i];
            m_pdf.addObject(page, "<< /Type /Page /Parent " + reference(m_pageTree) + " /MediaBox " + box +
                                      " /Contents " + reference(m_contents[i]) + " /Resources << /Properties << " +
                                      layersOf(page) + ">>" + m_shared + " >> >>");
            kids += reference(page) + ' ';
        }
        m_pdf.addObject(m_pageTree,
                        "<< /Type /Pages /Count " + std::to_string(m_pageObjects.size()) + " /Kids [" + kids + "] >>");
    }

    /// A bookmark per layer.
    [[nodiscard]] int writeOutlines() {
        const int root = m_pdf.reserve();
        std::vector<int> items;
        for (std::size_t i = 0; i < m_layers.size(); ++i) {
            items.push_back(m_pdf.reserve());
        }
        for (std::size_t i = 0; i < items.size(); ++i) {
            m_pdf.addObject(items[i], "<< /Title " + pdfText(m_layers[i].name) + " /Parent " + reference(root) +
                                          (i > 0 ? " /Prev " + reference(items[i - 1]) : "") +
                                          (i + 1 < items.size() ? " /Next " + reference(items[i + 1]) : "") +
                                          " /Dest [" + reference(m_layers[i].page) + " /Fit] >>");
        }
        m_pdf.addObject(root, "<< /Type /Outlines /First " + reference(items.front()) + " /Last " +
                                  reference(items.back()) + " /Count " + std::to_string(items.size()) + " >>");
        return root;
    }

    [[nodiscard]] int writeCatalog() {
        std::string groups;
        for (const LayerObject& layer : m_layers) {
            groups += reference(layer.group) + ' ';
        }
        const bool hasBookmarks = m_pages != PdfPages::AllOnOne;
        const std::string shown =
            hasBookmarks ? " /Outlines " + reference(writeOutlines()) + " /PageMode /UseOutlines" : " /PageMode /UseOC";
        const int catalog = m_pdf.reserve();
        m_pdf.addObject(catalog, "<< /Type /Catalog /Pages " + reference(m_pageTree) + shown +
                                     " /OCProperties << /OCGs [" + groups + "] /D << /Order [" + groups + "] /ON [" +
                                     groups + "] >> >> /ViewerPreferences << /PrintScaling /None >> >>");
        return catalog;
    }

    PdfFile m_pdf;
    Nm m_margin;
    PdfPages m_pages;
    std::string m_title;
    PointD m_origin;
    double m_width = 0.0;  ///< points
    double m_height = 0.0;
    std::vector<LayerObject> m_layers;
    std::vector<int> m_pageObjects;
    std::vector<int> m_contents;  ///< of the pages
    int m_pageTree = 0;
    bool m_isOutline = false;   ///< what is drawn now
    bool m_isMirrored = false;  ///< likewise
    bool m_hasOutline = false;
    std::string m_outline;  ///< its paths
    std::string m_shared;   ///< resources of every page
    std::string m_path;
};

}  // namespace

base::Result<DrawingReport> writePdf(const Document& board, const DrawingOptions& options, PdfPages pages,
                                     FileWriter& file, base::Progress& progress) {
    PdfForm form(file, options.margin, pages);
    const DrawingOrder order = pages == PdfPages::AllOnOne ? DrawingOrder::BottomFirst : DrawingOrder::AsListed;
    return drawLayers(board, options, order, form, file, progress);
}

}  // namespace model
