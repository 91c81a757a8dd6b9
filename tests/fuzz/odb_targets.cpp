#include <string>

#include "model/base/assert.h"
#include "model/formats/common/archive.h"
#include "model/formats/common/archive_stream.h"
#include "model/formats/odb/components/components.h"
#include "model/formats/odb/components/eda.h"
#include "model/formats/odb/components/netlist.h"
#include "model/formats/odb/features/features.h"
#include "model/formats/odb/features/tools.h"
#include "model/formats/odb/job_info.h"
#include "model/formats/odb/odb_reader.h"
#include "model/formats/odb/stackup/layer_facts.h"
#include "model/formats/odb/stackup/matrix.h"
#include "model/formats/odb/stackup/stackup_xml.h"
#include "model/formats/odb/stackup/zones.h"
#include "model/formats/odb/steps/step_header.h"
#include "model/formats/odb/symbols/standard_symbols.h"
#include "model/formats/odb/text/job_tree.h"
#include "tar.h"
#include "targets.h"

namespace fuzz {

namespace {

using model::Diagnostics;
using model::odb::Unit;

constexpr const char* kFile = "input";
constexpr model::formats::ArchiveLimits kLimits{std::uint64_t{16} << 20, 1'000};

/// A board around the file under test: a matrix of two copper layers and a drill, a profile, and one user symbol.
constexpr std::string_view kSmallJob =
    "=== matrix/matrix\nSTEP {\nCOL=1\nNAME=S\n}\nLAYER {\nROW=1\nCONTEXT=BOARD\nTYPE=SIGNAL\nNAME=TOP\n}\n"
    "LAYER {\nROW=2\nCONTEXT=BOARD\nTYPE=SIGNAL\nNAME=BOT\n}\n"
    "LAYER {\nROW=3\nCONTEXT=BOARD\nTYPE=DRILL\nNAME=D\nSTART_NAME=TOP\nEND_NAME=BOT\n}\n"
    "=== steps/s/profile\nUNITS=MM\nS P 0\nOB 0 0 I\nOS 20 0\nOS 20 20\nOS 0 20\nOS 0 0\nOE\nSE\n";

void readMembers(const model::formats::Archive& archive) {
    for (int row = 0; row < static_cast<int>(archive.size()); ++row) {
        auto bytes = archive.bytes(row);
        if (bytes) {
            static_cast<void>(model::formats::decodeMember(std::move(*bytes), kLimits.totalBytes));
        }
    }
}

void archive(std::string_view input) {
    base::Progress progress;
    Diagnostics diagnostics;
    const auto opened = model::formats::Archive::unpack(input, kFile, kLimits, progress, diagnostics);
    if (opened) {
        readMembers(*opened);
        static_cast<void>(model::odb::findJob(*opened));
    }
}

void member(std::string_view input) {
    static_cast<void>(model::formats::decodeMember(model::formats::Bytes::borrow(input), kLimits.totalBytes));
}

void job(std::string_view input) {
    base::Progress progress;
    Diagnostics diagnostics;
    const std::string tar = writeTar(unbundle(input));
    const auto opened = model::formats::Archive::unpack(tar, kFile, kLimits, progress, diagnostics);
    if (opened) {
        static_cast<void>(model::odb::readJob(*opened, kFile, {}, diagnostics, progress));
    }
}

/// `input` as one file of the small job.
void inSmallJob(const char* path, std::string_view input, std::string_view rest = {}) {
    job(std::string(kSmallJob) + std::string(rest) + "=== " + path + "\n" + std::string(input));
}

void matrix(std::string_view input) {
    Diagnostics diagnostics;
    const model::odb::Matrix parsed = model::odb::parseMatrix(input, kFile, diagnostics);
    const std::size_t rows = model::odb::physicalOrder(parsed.layers, kFile, diagnostics).size();
    ASSERT(rows == parsed.layers.size());
}

void stepHeader(std::string_view input) {
    Diagnostics diagnostics;
    static_cast<void>(model::odb::parseStepHeader(input, kFile, Unit::Inch, diagnostics));
}

void stackupXml(std::string_view input) {
    Diagnostics diagnostics;
    const model::odb::StackupXml parsed = model::odb::parseStackupXml(input, kFile, diagnostics);
    model::StackupFacts facts;
    model::odb::mergeStackupXml(parsed, kFile, {}, facts, diagnostics);
}

void tools(std::string_view input) {
    Diagnostics diagnostics;
    static_cast<void>(model::odb::parseTools(input, kFile, diagnostics));
}

void info(std::string_view input) {
    Diagnostics diagnostics;
    static_cast<void>(model::odb::parseInfo(input, kFile, diagnostics));
}

void attributes(std::string_view input) {
    Diagnostics diagnostics;
    const model::odb::AttributeList list(input, kFile, Unit::Inch, diagnostics);
    static_cast<void>(list.number(".board_thickness"));
}

void features(std::string_view input) {
    Diagnostics diagnostics;
    static_cast<void>(model::odb::parseFeatures(input, kFile, Unit::Millimetre, diagnostics));
}

void elements(std::string_view input) {
    inSmallJob("steps/s/layers/top/features", input);
}

void holes(std::string_view input) {
    inSmallJob("steps/s/layers/d/features", input);
}

void symbol(std::string_view input) {
    inSmallJob("symbols/u/features", input,
               "=== steps/s/layers/top/features\nUNITS=MM\n$0 u\nP 5 5 0 P 0 0\nP 9 9 0 N 0 8 30\n");
}

void profile(std::string_view input) {
    inSmallJob("steps/s/profile", input,
               "=== steps/s/layers/d/features\nUNITS=MM\n$0 r500\nP 5 5 0 P 0 0\nL 0 0 9 0 0 P 0\n");
}

void font(std::string_view input) {
    inSmallJob("fonts/standard", input,
               "=== steps/s/layers/top/features\nUNITS=MM\nT 1 1 standard P 0 1 1 0.5 'L;L x' 1\n"
               "B 1 1 UPC39 standard P 0 E 0.5 2 Y Y N T 'L1'\n");
}

/// The input is the name of a symbol.
void symbolName(std::string_view input) {
    static_cast<void>(model::odb::standardSymbol({std::string(input), Unit::Millimetre, 0}));
    static_cast<void>(model::odb::standardSymbol({std::string(input), Unit::Inch, 1000}));
}

void components(std::string_view input) {
    Diagnostics diagnostics;
    static_cast<void>(model::odb::parseComponents(input, kFile, Unit::Inch, {}, diagnostics));
}

void eda(std::string_view input) {
    Diagnostics diagnostics;
    static_cast<void>(
        model::odb::parseEda(input, kFile, Unit::Inch, {"TOP", "Inner Plane", "BOTTOM"}, {}, diagnostics));
}

void netlist(std::string_view input) {
    Diagnostics diagnostics;
    static_cast<void>(model::odb::parseNetlist(input, kFile, Unit::Inch, diagnostics));
}

void zones(std::string_view input) {
    Diagnostics diagnostics;
    static_cast<void>(model::odb::parseZones(input, kFile, Unit::Inch, diagnostics));
    inSmallJob("steps/s/zones", input, "=== steps/s/layers/top/features\nUNITS=MM\n$0 r500\nP 5 5 0 P 0 0\n");
}

}  // namespace

std::span<const Target> odbTargets() {
    static const std::vector<Target> kTargets = {
        {"archive", archive},
        {"attributes", attributes, {"attrlist"}},
        {"components", components, {"components"}},
        {"eda", eda, {"data"}},
        {"elements", elements, {"features"}},
        {"features", features, {"features", "profile"}},
        {"font", font},
        {"holes", holes, {"features"}},
        {"info", info, {"info"}},
        {"job", job, {}, true},
        {"matrix", matrix, {"matrix"}},
        {"member", member},
        {"netlist", netlist, {"netlist"}},
        {"profile", profile, {"profile"}},
        {"stackup_xml", stackupXml},
        {"step_header", stepHeader, {"stephdr"}},
        {"symbol", symbol, {"features"}},
        {"symbol_name", symbolName},
        {"tools", tools, {"tools"}},
        {"zones", zones, {"zones"}},
    };
    return kTargets;
}

}  // namespace fuzz
