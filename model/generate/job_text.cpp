#include "model/generate/job_text.h"

namespace model::generate {

namespace {

struct LayerRow {
    const char* name;
    const char* type;
};
// By Sheet.
constexpr LayerRow kLayers[kLayerCount] = {{"silk_top", "SILK_SCREEN"}, {"top", "SIGNAL"},
                                           {"ground", "POWER_GROUND"},  {"power", "POWER_GROUND"},
                                           {"bottom", "SIGNAL"},        {"drill", "DRILL"}};
// By Pen; micrometres.
constexpr const char* kSymbols[] = {
    "r75", "r100", "r300", "r350", "r150", "rect200x480xr60", "rect220x500xr60", "rect240x520xr80"};
constexpr const char* kMatrixOrder[] = {"silk_top", "top",   "core1",  "ground", "core2",
                                        "power",    "core3", "bottom", "drill"};
constexpr const char* kStep = "steps/board/";

std::string layerFolder(std::string_view layer) {
    return std::string(kStep) + "layers/" + std::string(layer) + "/";
}

const char* typeOf(std::string_view layer) {
    for (const LayerRow& plane : kLayers) {
        if (layer == plane.name) {
            return plane.type;
        }
    }
    return "DIELECTRIC";
}

void writeMatrix(TextSink& out) {
    out << "STEP {\n    COL=1\n    NAME=BOARD\n}\n";
    std::int64_t row = 0;
    for (const std::string_view layer : kMatrixOrder) {
        const bool isDrill = layer == "drill";
        out << "\nLAYER {\n    ROW=" << ++row << "\n    CONTEXT=BOARD\n    TYPE=" << typeOf(layer)
            << "\n    NAME=" << layer << "\n    POLARITY=POSITIVE\n    START_NAME=" << (isDrill ? "top" : "")
            << "\n    END_NAME=" << (isDrill ? "bottom" : "") << "\n}\n";
    }
}

// ---- features ----

void writePoint(TextSink& out, PointUm p) {
    out << " ";
    out.mm(p.x) << " ";
    out.mm(p.y);
}

void writeSymbols(TextSink& out) {
    out << "UNITS=MM\n";
    for (std::size_t pen = 0; pen < std::size(kSymbols); ++pen) {
        out << "$" << static_cast<std::int64_t>(pen) << " " << kSymbols[pen] << "\n";
    }
}

void writeFeature(TextSink& out, const Feature& feature) {
    struct Record {
        const char* letter;
        const char* tail;
    };
    constexpr Record kRecords[] = {{"L", " P 0\n"}, {"A", " P 0 Y\n"}, {"P", " P 0 0\n"}};  // by Feature::Kind
    const Record& record = kRecords[static_cast<std::size_t>(feature.kind)];
    out << record.letter;
    writePoint(out, feature.a);
    if (feature.kind != Feature::Kind::Pad) {
        writePoint(out, feature.b);
    }
    if (feature.kind == Feature::Kind::Arc) {
        writePoint(out, feature.centre);
    }
    out << " " << static_cast<std::int64_t>(feature.pen) << record.tail;
}

void writeBlocks(TextSink& out, const Layout& layout, BoardLayer plane, const base::Progress& progress) {
    writeSymbols(out);
    for (std::uint64_t i = 0; i < layout.blockCount() && !progress.isCancelled(); ++i) {
        const Block block = layout.block(i);
        for (const Feature& feature : block.features[static_cast<std::size_t>(plane)]) {
            writeFeature(out, feature);
        }
    }
}

void writeRectangle(TextSink& out, PointUm min, PointUm max) {
    out << "OB";
    writePoint(out, min);
    out << " I\n";
    for (const PointUm corner : {PointUm{min.x, max.y}, max, PointUm{max.x, min.y}, min}) {
        out << "OS";
        writePoint(out, corner);
        out << "\n";
    }
    out << "OE\n";
}

/// A full circle: begins and ends to the right of its centre.
void writeHole(TextSink& out, PointUm centre) {
    const PointUm start{centre.x + Layout::kViaClearanceUm, centre.y};
    out << "OB";
    writePoint(out, start);
    out << " H\nOC";
    writePoint(out, start);
    writePoint(out, centre);
    out << " N\nOE\n";
}

void writePlanes(TextSink& out, const Layout& layout, bool isGround, const base::Progress& progress) {
    writeSymbols(out);
    for (std::uint64_t i = 0; i < layout.tileCount() && !progress.isCancelled(); ++i) {
        const Tile tile = layout.tile(i);
        out << "S P 0\n";
        writeRectangle(out, tile.min, tile.max);
        for (const std::uint64_t index : tile.blocks) {
            const Block block = layout.block(index);
            for (const PointUm via : isGround ? block.viasNotOnGround : block.viasNotOnPower) {
                writeHole(out, via);
            }
        }
        out << "SE\n";
    }
}

void writeProfile(TextSink& out, const Layout& layout) {
    out << "UNITS=MM\nS P 0\n";
    writeRectangle(out, layout.min(), layout.max());
    out << "SE\n";
}

// ---- nets ----

/// Counts the features of each layer while blocks go by in the order in which they are written.
class NetWriter {
public:
    NetWriter(TextSink& out, const Layout& layout, const base::Progress& progress)
        : m_out(out), m_layout(layout), m_progress(progress) {}

    void write() {
        m_out << "HDR Copperscope\nLYR";
        for (const LayerRow& plane : kLayers) {
            m_out << " " << plane.name;
        }
        m_out << "\n";
        writePlaneNet("GND", kGroundNet, BoardLayer::Ground);
        writePlaneNet("VCC", kPowerNet, BoardLayer::Power);
        forBlocks([&](const Block& block, std::uint64_t index) {
            for (BlockNet net = 0; net < block.netCount; ++net) {
                m_out << "NET N" << static_cast<std::int64_t>(index) << "_" << std::int64_t{net} << "\nSNT TRC\n";
                writeLinks(block, net);
            }
        });
    }

private:
    using Counts = std::array<std::int64_t, kLayerCount>;

    template <class Visit>
    void forBlocks(const Visit& visit) {
        m_before = {};
        for (std::uint64_t i = 0; i < m_layout.blockCount() && !m_progress.isCancelled(); ++i) {
            const Block block = m_layout.block(i);
            visit(block, i);
            for (std::size_t plane = 0; plane < kLayerCount; ++plane) {
                m_before[plane] += static_cast<std::int64_t>(block.features[plane].size());
            }
        }
    }

    void writePlaneNet(const char* name, BlockNet net, BoardLayer plane) {
        m_out << "NET " << name << "\nSNT PLN S E 0\n";
        for (std::uint64_t tile = 0; tile < m_layout.tileCount(); ++tile) {
            writeLink("C", static_cast<std::size_t>(plane), static_cast<std::int64_t>(tile));
        }
        m_out << "SNT VIA\n";
        forBlocks([&](const Block& block, std::uint64_t) { writeLinks(block, net); });
    }

    void writeLinks(const Block& block, BlockNet net) {
        for (std::size_t plane = 0; plane < kLayerCount; ++plane) {
            const std::vector<Feature>& features = block.features[plane];
            for (std::size_t i = 0; i < features.size(); ++i) {
                if (features[i].net == net) {
                    writeLink(plane == static_cast<std::size_t>(BoardLayer::Drill) ? "H" : "C", plane,
                              m_before[plane] + static_cast<std::int64_t>(i));
                }
            }
        }
    }

    void writeLink(const char* kind, std::size_t plane, std::int64_t feature) {
        m_out << "FID " << kind << " " << static_cast<std::int64_t>(plane) << " " << feature << "\n";
    }

    TextSink& m_out;
    const Layout& m_layout;
    const base::Progress& m_progress;
    Counts m_before{};
};

JobFile fixedFile(std::string path, std::string text) {
    return {std::move(path), [text = std::move(text)](TextSink& out) { out << text; }};
}

/// 35 µm copper outside, 17.5 µm inside; 1.6 mm in all.
void addThicknesses(std::vector<JobFile>& files) {
    const auto add = [&](const char* layer, const char* attribute) {
        files.push_back(fixedFile(layerFolder(layer) + "attrlist", "UNITS=MM\n" + std::string(attribute) + "\n"));
    };
    add("top", ".copper_weight=35");
    add("ground", ".copper_weight=17.5");
    add("power", ".copper_weight=17.5");
    add("bottom", ".copper_weight=35");
    add("core1", ".layer_dielectric=0.2");
    add("core2", ".layer_dielectric=1.095");
    add("core3", ".layer_dielectric=0.2");
}

}  // namespace

std::vector<JobFile> jobFiles(const Layout& layout, const base::Progress& progress) {
    std::vector<JobFile> files;
    files.push_back({"matrix/matrix", writeMatrix});
    files.push_back(fixedFile("misc/info",
                              "JOB_NAME=generated\nUNITS=MM\nODB_VERSION_MAJOR=8\nODB_VERSION_MINOR=1\n"
                              "ODB_SOURCE=Copperscope\nSAVE_APP=Copperscope generate\n"));
    files.push_back(fixedFile("misc/attrlist", "UNITS=MM\n.board_thickness=1.6\n"));
    files.push_back(fixedFile(std::string(kStep) + "stephdr", "UNITS=MM\nX_DATUM=0\nY_DATUM=0\n"));
    files.push_back({std::string(kStep) + "profile", [&layout](TextSink& out) { writeProfile(out, layout); }});
    for (const BoardLayer plane : {BoardLayer::Silk, BoardLayer::Top, BoardLayer::Bottom, BoardLayer::Drill}) {
        files.push_back({layerFolder(kLayers[static_cast<std::size_t>(plane)].name) + "features",
                         [&layout, &progress, plane](TextSink& out) { writeBlocks(out, layout, plane, progress); }});
    }
    for (const bool isGround : {true, false}) {
        files.push_back(
            {layerFolder(isGround ? "ground" : "power") + "features",
             [&layout, &progress, isGround](TextSink& out) { writePlanes(out, layout, isGround, progress); }});
    }
    files.push_back(fixedFile(layerFolder("drill") + "tools",
                              "UNITS=MM\nTHICKNESS=0\nUSER_PARAMS=\nTOOLS {\n    NUM=1\n    TYPE=VIA\n"
                              "    FINISH_SIZE=150\n    DRILL_SIZE=150\n}\n"));
    addThicknesses(files);
    files.push_back({std::string(kStep) + "eda/data",
                     [&layout, &progress](TextSink& out) { NetWriter(out, layout, progress).write(); }});
    return files;
}

}  // namespace model::generate
