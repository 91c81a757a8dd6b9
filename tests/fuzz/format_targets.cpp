#include <map>
#include <string>

#include "model/base/assert.h"
#include "model/formats/board_forms.h"
#include "model/formats/common/archive.h"
#include "model/formats/drawing/assembly.h"
#include "model/formats/gerber/drills/drill_file.h"
#include "model/formats/gerber/gerber_reader.h"
#include "model/formats/gerber/image/image.h"
#include "model/formats/gerber/job_file.h"
#include "model/formats/gerber/naming/layer_pairs.h"
#include "model/formats/gerber/netlist/d356.h"
#include "model/formats/gerber/placements.h"
#include "model/formats/ipc2581/ipc_reader.h"
#include "model/formats/kicad/board_drawing.h"
#include "model/formats/paper/paper_reader.h"
#include "tar.h"
#include "targets.h"

namespace fuzz {

namespace {

using model::Diagnostics;

constexpr const char* kFile = "input";
constexpr model::formats::ArchiveLimits kLimits{std::uint64_t{16} << 20, 1'000};

void ipc2581(std::string_view input) {
    base::Progress progress;
    static_cast<void>(model::ipc2581::looksLikeIpc2581(input));
    static_cast<void>(model::ipc2581::readJob(input, kFile, {}, {}, progress, {}));
}

void kicad(std::string_view input) {
    base::Progress progress;
    auto drawn = model::kicad::drawBoard(input, kFile, {}, progress);
    if (drawn) {
        static_cast<void>(model::formats::assemble(*std::move(drawn), 0.0, progress));
    }
}

void kicadProject(std::string_view input) {
    Diagnostics diagnostics;
    static_cast<void>(model::kicad::readProject(input, kFile, diagnostics).classOf("GND"));
}

void paper(std::string_view input) {
    base::Progress progress;
    static_cast<void>(model::paper::readModel(input, kFile, progress));
}

void gerberImage(std::string_view input) {
    static_cast<void>(model::gerber::parseImage(input, kFile));
}

void gerberDrills(std::string_view input) {
    for (const model::gerber::CoordinateFormat& format :
         model::gerber::likelyFormats(model::gerber::readDrillHead(input))) {
        static_cast<void>(model::gerber::parseDrills(input, kFile, format));
    }
}

void gerberJob(std::string_view input) {
    base::Progress progress;
    Diagnostics diagnostics;
    const std::string tar = writeTar(unbundle(input));
    const auto opened = model::formats::Archive::unpack(tar, kFile, kLimits, progress, diagnostics);
    if (opened) {
        static_cast<void>(model::gerber::readJob(*opened, kFile, {}, diagnostics, progress));
    }
}

void gerberJobFile(std::string_view input) {
    Diagnostics diagnostics;
    static_cast<void>(model::gerber::looksLikeJobFile(input));
    static_cast<void>(model::gerber::parseJobFile(input, kFile, diagnostics));
}

void gerberNetlist(std::string_view input) {
    Diagnostics diagnostics;
    static_cast<void>(model::gerber::looksLikeD356(input));
    const model::gerber::D356 read = model::gerber::parseD356(input, kFile, diagnostics);
    for (const model::gerber::D356Point& point : read.points) {
        ASSERT(point.net < static_cast<std::int32_t>(read.nets.size()));
    }
}

void gerberPlacements(std::string_view input) {
    Diagnostics diagnostics;
    static_cast<void>(model::gerber::looksLikePlacements(input));
    static_cast<void>(model::gerber::parsePlacements(input, kFile, diagnostics));
    static_cast<void>(model::gerber::parseLayerPairs(input));
}

/// A folder or archive of files of any kind. Files below `name.tar/` are in an archive of that name.
void forms(std::string_view input) {
    std::vector<File> files;
    std::map<std::string, std::vector<File>> inner;
    for (File& file : unbundle(input)) {
        const std::size_t end = file.path.find(".tar/");
        if (end == std::string::npos) {
            files.push_back(std::move(file));
        } else {
            inner[file.path.substr(0, end + 4)].push_back({file.path.substr(end + 5), std::move(file.text)});
        }
    }
    for (const auto& [path, members] : inner) {
        files.push_back({path, writeTar(members)});
    }
    base::Progress progress;
    model::BoardInput board{kFile, {}, {}, {}, {}};
    auto opened = model::formats::Archive::unpack(writeTar(files), kFile, kLimits, progress, board.unpacking);
    if (!opened) {
        return;
    }
    board.archive = std::move(*opened);
    const auto found = model::formsIn(board, progress);
    for (const model::BoardForm& form : *found) {
        if (!model::isNamedLikeArchive(form.member)) {
            static_cast<void>(form.format->read(board, {}, progress));
        }
    }
    static_cast<void>(model::othersOf(*found, kFile));
}

}  // namespace

std::span<const Target> formatTargets() {
    static const std::vector<Target> kTargets = {
        {"forms", forms},
        {"gerber_drills", gerberDrills},
        {"gerber_image", gerberImage},
        {"gerber_job", gerberJob},
        {"gerber_job_file", gerberJobFile},
        {"gerber_netlist", gerberNetlist},
        {"gerber_placements", gerberPlacements},
        {"ipc2581", ipc2581},
        {"kicad", kicad, {}, false, "kicad"},
        {"kicad_project", kicadProject},
        {"paper", paper},
    };
    return kTargets;
}

}  // namespace fuzz
