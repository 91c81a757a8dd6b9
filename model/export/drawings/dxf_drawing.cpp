#include "model/export/drawings/dxf_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/export/drawings/drawing_paths.h"
#include "model/export/drawings/dxf_names.h"
#include "model/text/formatting.h"
#include "model/text/number_text.h"

namespace model {

namespace {

// Handles of what every drawing has; all others are counted up from kFirstFree.
constexpr unsigned kBlockRecords = 0x1;
constexpr unsigned kLayers = 0x2;
constexpr unsigned kStyles = 0x3;
constexpr unsigned kLineTypes = 0x5;
constexpr unsigned kViews = 0x6;
constexpr unsigned kUcs = 0x7;
constexpr unsigned kViewports = 0x8;
constexpr unsigned kApplications = 0x9;
constexpr unsigned kDimensionStyles = 0xA;
constexpr unsigned kRoot = 0xC;
constexpr unsigned kGroups = 0xD;
constexpr unsigned kModelSpace = 0x1F;
constexpr unsigned kPaperSpace = 0x1B;
constexpr unsigned kFirstFree = 0x100;
constexpr const char* kBehindAll = "7FFFFFFF";  // the next free handle, for programs that add to the drawing

// Of texts.
constexpr int kCentred = 1;
constexpr int kMiddle = 2;
constexpr double kCapitals = 2 * kNameBaseline;  // their height, which DXF states, of that of all letters

/// Groups of a code and a value, each on a line of its own.
class Groups {
public:
    explicit Groups(FileWriter& file) : m_file(file) {}

    Groups& text(int code, std::string_view value) {
        start(code);
        m_line += value;
        return finish();
    }
    Groups& number(int code, int value) { return text(code, std::to_string(value)); }
    Groups& handle(int code, unsigned value) { return text(code, formatted("%X", value)); }
    Groups& newHandle() { return handle(5, m_next++); }
    Groups& mm(int code, double nm) {
        start(code);
        appendMm(m_line, nm);
        return finish();
    }
    Groups& real(int code, double value, int digits) {
        start(code);
        appendNumber(m_line, value, digits);
        return finish();
    }
    Groups& section(const char* name) { return text(0, "SECTION").text(2, name); }
    Groups& endSection() { return text(0, "ENDSEC"); }
    Groups& table(const char* name, unsigned own, int rows) {
        return text(0, "TABLE")
            .text(2, name)
            .handle(5, own)
            .handle(330, 0)
            .text(100, "AcDbSymbolTable")
            .number(70, rows);
    }
    Groups& endTable() { return text(0, "ENDTAB"); }
    /// The start of a row of a table.
    Groups& row(const char* kind, unsigned table, const char* subclass, std::string_view name) {
        text(0, kind).newHandle().handle(330, table);
        return text(100, "AcDbSymbolTableRecord").text(100, subclass).text(2, name);
    }

private:
    void start(int code) {
        m_line = code < 10 ? "  " : code < 100 ? " " : "";
        m_line += std::to_string(code) + '\n';
    }
    Groups& finish() {
        m_line += '\n';
        m_file.write(m_line);
        return *this;
    }

    FileWriter& m_file;
    std::string m_line;
    unsigned m_next = kFirstFree;
};

class DxfForm : public DrawingForm {
public:
    explicit DxfForm(FileWriter& file) : m_out(file) {}

    void begin(const Drawing& drawing) override {
        writeHeader(drawing.box);
        m_out.section("CLASSES").endSection();
        m_out.section("TABLES");
        writeViewport(drawing.box);
        writeLineTypes();
        writeLayers(drawing.layers);
        writeSmallTables();
        m_out.endSection();
        writeBlocks();
        m_out.section("ENTITIES");
    }

    void beginLayer(const DrawnLayer& /*layer*/) override { m_layer = m_names[m_begun++]; }

    void addRegion(const EdgeLoops& region, RegionPaint /*paint*/) override {
        for (std::size_t i = 0; i < region.loopCount(); ++i) {
            const std::span<const Edge> loop = region.loop(i);
            if (loop.front().isFullCircle()) {
                addCircle(loop.front());
            } else {
                addPolyline(loop);
            }
        }
    }

    void addName(const DrawnName& name) override {
        beginEntity("TEXT", "AcDbText");
        addPlace(10, name.centre);
        m_out.mm(40, kCapitals * name.height).text(1, dxfText(name.text)).number(50, name.isUpright ? 90 : 0);
        m_out.number(72, kCentred);
        addPlace(11, name.centre);
        m_out.text(100, "AcDbText").number(73, kMiddle);
    }

    void endLayer() override {}

    void end() override {
        m_out.endSection();
        m_out.section("OBJECTS");
        m_out.text(0, "DICTIONARY").handle(5, kRoot).handle(330, 0).text(100, "AcDbDictionary").number(281, 1);
        m_out.text(3, "ACAD_GROUP").handle(350, kGroups);
        m_out.text(0, "DICTIONARY").handle(5, kGroups).handle(330, kRoot).text(100, "AcDbDictionary").number(281, 1);
        m_out.endSection().text(0, "EOF");
    }

private:
    void writeHeader(const Box& box) {
        m_out.section("HEADER");
        m_out.text(9, "$ACADVER").text(1, "AC1015").text(9, "$DWGCODEPAGE").text(3, "ANSI_1252");
        m_out.text(9, "$INSUNITS").number(70, 4).text(9, "$MEASUREMENT").number(70, 1);
        m_out.text(9, "$LUNITS").number(70, 2).text(9, "$LUPREC").number(70, 6);
        m_out.text(9, "$EXTMIN").mm(10, box.min.x).mm(20, box.min.y).number(30, 0);
        m_out.text(9, "$EXTMAX").mm(10, box.max.x).mm(20, box.max.y).number(30, 0);
        m_out.text(9, "$HANDSEED").text(5, kBehindAll);
        m_out.endSection();
    }

    /// Programs open with the whole board in view.
    void writeViewport(const Box& box) {
        const double width = static_cast<double>(box.width());
        const double height = static_cast<double>(box.height());
        m_out.table("VPORT", kViewports, 1).row("VPORT", kViewports, "AcDbViewportTableRecord", "*ACTIVE");
        m_out.number(70, 0).number(10, 0).number(20, 0).number(11, 1).number(21, 1);
        m_out.mm(12, box.min.x + width / 2).mm(22, box.min.y + height / 2);
        m_out.number(13, 0).number(23, 0).number(14, 10).number(24, 10).number(15, 10).number(25, 10);
        m_out.number(16, 0).number(26, 0).number(36, 1).number(17, 0).number(27, 0).number(37, 0);
        m_out.mm(40, 1.1 * std::max(height, width / 1.5)).real(41, 1.5, 1).number(42, 50).number(43, 0).number(44, 0);
        m_out.number(50, 0).number(51, 0).number(71, 0).number(72, 100).number(73, 1).number(74, 3).number(75, 0);
        m_out.number(76, 0).number(77, 0).number(78, 0).endTable();
    }

    void writeLineTypes() {
        m_out.table("LTYPE", kLineTypes, 3);
        for (const char* name : {"ByBlock", "ByLayer", "Continuous"}) {
            m_out.row("LTYPE", kLineTypes, "AcDbLinetypeTableRecord", name).number(70, 0);
            m_out.text(3, name == std::string_view("Continuous") ? "Solid line" : "").number(72, 65).number(73, 0);
            m_out.number(40, 0);
        }
        m_out.endTable();
    }

    void writeLayers(const std::vector<DrawnLayer>& layers) {
        m_out.table("LAYER", kLayers, static_cast<int>(layers.size()) + 1);
        writeLayer("0", 7);
        DxfNames names;
        for (const DrawnLayer& layer : layers) {
            m_names.push_back(names.unique(layer.name));
            writeLayer(m_names.back(), dxfColour(layer.colour));
        }
        m_out.endTable();
    }

    void writeLayer(const std::string& name, int colour) {
        m_out.row("LAYER", kLayers, "AcDbLayerTableRecord", name).number(70, 0).number(62, colour);
        m_out.text(6, "Continuous");
    }

    void writeSmallTables() {
        m_out.table("STYLE", kStyles, 1).row("STYLE", kStyles, "AcDbTextStyleTableRecord", "Standard").number(70, 0);
        m_out.number(40, 0).number(41, 1).number(50, 0).number(71, 0).real(42, 2.5, 1).text(3, "txt").text(4, "");
        m_out.endTable();
        m_out.table("VIEW", kViews, 0).endTable().table("UCS", kUcs, 0).endTable();
        m_out.table("APPID", kApplications, 1);
        m_out.row("APPID", kApplications, "AcDbRegAppTableRecord", "ACAD").number(70, 0).endTable();
        m_out.table("DIMSTYLE", kDimensionStyles, 0).text(100, "AcDbDimStyleTable").endTable();
        m_out.table("BLOCK_RECORD", kBlockRecords, 2);
        for (const auto& [name, own] : {std::pair{"*Model_Space", kModelSpace}, {"*Paper_Space", kPaperSpace}}) {
            m_out.text(0, "BLOCK_RECORD").handle(5, own).handle(330, kBlockRecords);
            m_out.text(100, "AcDbSymbolTableRecord").text(100, "AcDbBlockTableRecord").text(2, name).handle(340, 0);
        }
        m_out.endTable();
    }

    void writeBlocks() {
        m_out.section("BLOCKS");
        for (const auto& [name, record] : {std::pair{"*Model_Space", kModelSpace}, {"*Paper_Space", kPaperSpace}}) {
            m_out.text(0, "BLOCK").newHandle().handle(330, record).text(100, "AcDbEntity").text(8, "0");
            m_out.text(100, "AcDbBlockBegin").text(2, name).number(70, 0).number(10, 0).number(20, 0).number(30, 0);
            m_out.text(3, name).text(1, "");
            m_out.text(0, "ENDBLK").newHandle().handle(330, record).text(100, "AcDbEntity").text(8, "0");
            m_out.text(100, "AcDbBlockEnd");
        }
        m_out.endSection();
    }

    void beginEntity(const char* kind, const char* subclass) {
        m_out.text(0, kind).newHandle().handle(330, kModelSpace).text(100, "AcDbEntity").text(8, m_layer);
        m_out.text(100, subclass);
    }

    void addPlace(int code, PointD at) { m_out.mm(code, at.x).mm(code + 10, at.y).number(code + 20, 0); }

    void addCircle(const Edge& circle) {
        beginEntity("CIRCLE", "AcDbCircle");
        addPlace(10, circle.centre);
        m_out.mm(40, circle.radius);
    }

    void addPolyline(std::span<const Edge> loop) {
        m_pieces.clear();
        for (const Edge& edge : loop) {
            const std::vector<Edge> pieces = shortPiecesOf(edge, std::numbers::pi);
            m_pieces.insert(m_pieces.end(), pieces.begin(), pieces.end());
        }
        beginEntity("LWPOLYLINE", "AcDbPolyline");
        m_out.number(90, static_cast<int>(m_pieces.size())).number(70, 1);
        for (const Edge& piece : m_pieces) {
            m_out.mm(10, piece.a.x).mm(20, piece.a.y);
            if (piece.isArc()) {
                m_out.real(42, std::tan(sweepOf(piece) / 4), 12);
            }
        }
    }

    Groups m_out;
    std::vector<std::string> m_names;  ///< of layers, in their order
    std::size_t m_begun = 0;
    std::string m_layer;
    std::vector<Edge> m_pieces;
};

}  // namespace

base::Result<DrawingReport> writeDxf(const Document& board, const DrawingOptions& options, FileWriter& file,
                                     base::Progress& progress) {
    DxfForm form(file);
    return drawLayers(board, options, DrawingOrder::AsListed, form, file, progress);
}

}  // namespace model
