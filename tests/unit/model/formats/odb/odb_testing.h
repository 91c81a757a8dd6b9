#pragma once

#include <archive.h>
#include <archive_entry.h>

#include <QTemporaryDir>
#include <QtTest>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "model/figures/element_polygons.h"
#include "model/formats/registry.h"
#include "model/geometry/discretise.h"
#include "tests/locations.h"

/// Shared by the tests of the ODB++ reader: jobs written on the spot, archives of every kind, short ways to ask a
/// document.
namespace odb_testing {

namespace fs = std::filesystem;

inline std::string readFile(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline void writeFile(const fs::path& path, const std::string& bytes) {
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << bytes;
}

/// A temporary folder.
class Folder {
public:
    [[nodiscard]] fs::path path() const { return m_folder.path().toStdString(); }
    fs::path write(const std::string& name, const std::string& bytes) const {
        writeFile(path() / name, bytes);
        return path() / name;
    }
    /// Copies a job of tests/data/odb into this folder.
    void copyJob(const std::string& name) const {
        fs::copy(fs::path(locations::kTestData) / "odb" / name, path(),
                 fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    }

private:
    QTemporaryDir m_folder;
};

/// A matrix with step BOARD and these layers, each "TYPE NAME", all CONTEXT=BOARD.
inline std::string matrixOf(const std::vector<std::pair<std::string, std::string>>& layers) {
    std::string text = "STEP {\n COL=1\n NAME=BOARD\n}\n";
    int row = 0;
    for (const auto& [type, name] : layers) {
        text +=
            "LAYER {\n ROW=" + std::to_string(++row) + "\n CONTEXT=BOARD\n TYPE=" + type + "\n NAME=" + name + "\n}\n";
    }
    return text;
}

/// A job of one copper layer TOP with these features, and a profile of 100 × 100 mm.
inline void writeSmallJob(const Folder& folder, const std::string& features) {
    folder.write("matrix/matrix", matrixOf({{"SIGNAL", "TOP"}}));
    folder.write("steps/board/profile", "UNITS=MM\nS P 0\nOB 0 0 I\nOS 100 0\nOS 100 100\nOS 0 100\nOS 0 0\nOE\nSE\n");
    folder.write("steps/board/layers/top/features", features);
}

inline base::Result<std::shared_ptr<const model::Document>> tryRead(const fs::path& path,
                                                                    const std::string& step = {}) {
    base::Progress progress;
    return model::readBoard(path, {step}, progress);
}

/// Reads a job that must be readable.
inline std::shared_ptr<const model::Document> read(const fs::path& path, const std::string& step = {}) {
    auto result = tryRead(path, step);
    if (!result) {
        qFatal("%s", result.error().text.c_str());
    }
    return *result;
}

inline fs::path dataJob(const std::string& name) {
    return fs::path(locations::kTestData) / "odb" / name;
}

/// The first diagnostic whose text holds `part`, or begins with it but for the capital; nullptr if there is none.
inline const model::Diagnostic* findDiagnostic(const model::Diagnostics& diagnostics, const std::string& part) {
    for (const model::Diagnostic& entry : diagnostics.entries()) {
        const bool isStart = part.size() > 1 && entry.text.find(part.substr(1)) == 1;
        if (isStart || entry.text.find(part) != std::string::npos) {
            return &entry;
        }
    }
    return nullptr;
}

/// The element of a layer that was made from this feature (trails: from their first one); invalid if there is none.
inline model::ElementId elementOf(const model::Document& document, const std::string& layer, std::uint32_t feature) {
    const model::Layer& found = document.layer(document.findLayer(layer));
    for (std::uint32_t i = 0; i < found.elements.count; ++i) {
        if (document.elements.firstFeature[found.elements.first + i] == feature) {
            return model::ElementId{found.elements.first + i};
        }
    }
    return {};
}

/// In mm².
inline double squareMillimetres(const model::Document& d, model::ElementId id) {
    return static_cast<double>(model::twiceArea(model::discretise(d, id, {500.0, false}))) / 2e12;
}

inline const model::Layer& layerOf(const model::Document& d, const char* name) {
    const model::LayerId id = d.findLayer(name);
    if (!id.isValid()) {
        qFatal("no layer %s", name);
    }
    return d.layer(id);
}

enum class Packing { Plain, Gzip, Compress };
enum class Container { V7Tar, Ustar, Zip, Raw };

struct Member {
    std::string name;
    std::string bytes;
    unsigned mode = 0644;
    std::string linkTo;  ///< makes it a symbolic link
};

/// Writes an archive with libarchive's writer. Raw holds one nameless member.
inline void writeArchive(const fs::path& path, Container container, Packing packing,
                         const std::vector<Member>& members) {
    archive* out = archive_write_new();
    switch (container) {
        case Container::V7Tar: archive_write_set_format_v7tar(out); break;
        case Container::Ustar: archive_write_set_format_ustar(out); break;
        case Container::Zip: archive_write_set_format_zip(out); break;
        case Container::Raw: archive_write_set_format_raw(out); break;
    }
    if (packing == Packing::Gzip) {
        archive_write_add_filter_gzip(out);
    } else if (packing == Packing::Compress) {
        archive_write_add_filter_compress(out);
    }
    if (archive_write_open_filename(out, path.c_str()) != ARCHIVE_OK) {
        qFatal("cannot write %s", path.c_str());
    }
    for (const Member& member : members) {
        archive_entry* entry = archive_entry_new();
        archive_entry_set_pathname(entry, member.name.c_str());
        archive_entry_set_filetype(entry, member.linkTo.empty() ? AE_IFREG : AE_IFLNK);
        if (!member.linkTo.empty()) {
            archive_entry_set_symlink(entry, member.linkTo.c_str());
        }
        archive_entry_set_perm(entry, member.mode);
        archive_entry_set_size(entry, member.linkTo.empty() ? static_cast<la_int64_t>(member.bytes.size()) : 0);
        archive_write_header(out, entry);
        archive_write_data(out, member.bytes.data(), member.bytes.size());
        archive_entry_free(entry);
    }
    archive_write_close(out);
    archive_write_free(out);
}

/// All files of a folder as members below `prefix`.
inline std::vector<Member> membersOf(const fs::path& folder, const std::string& prefix, unsigned mode = 0644) {
    std::vector<Member> members;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            members.push_back(
                {prefix + entry.path().lexically_relative(folder).generic_string(), readFile(entry.path()), mode, {}});
        }
    }
    return members;
}

/// Everything a document says, the steps it places included, as text that can be compared.
inline std::string fingerprint(const model::Document& d) {
    std::string text;
    for (const auto& step : d.steps) {
        text += fingerprint(*step);
    }
    const auto put = [&text](auto... values) { ((text += std::to_string(values) + ' '), ...); };
    const auto point = [&put](model::Point p) { put(p.x, p.y); };
    for (const model::Layer& layer : d.layers) {
        text += layer.name + ' ' + layer.file + ' ';
        put(layer.z, layer.thickness, layer.elements.first, layer.elements.count);
    }
    for (std::size_t i = 0; i < d.elements.size(); ++i) {
        put(static_cast<int>(d.elements.kind[i]), int{d.elements.flags[i]}, d.elements.layer[i].value,
            d.elements.net[i].value, d.elements.symbol[i].value, d.elements.geometry[i], d.elements.firstFeature[i],
            d.elements.line[i]);
    }
    for (const model::LineGeometry& line : d.lines) {
        point(line.a);
        point(line.b);
        put(line.width, line.innerWidth);
    }
    for (const model::PathNode& node : d.trailNodes) {
        point(node.point);
        point(node.centre);
        put(static_cast<int>(node.edge));
    }
    for (const model::PathNode& node : d.shapes.nodes) {
        point(node.point);
        point(node.centre);
        put(static_cast<int>(node.edge));
    }
    for (const model::AreaGeometry& area : d.areas) {
        point(area.placement.origin);
        put(area.shape.value, area.placement.clockwiseDeg, int{area.placement.isMirrored});
    }
    for (const model::StepInstance& copy : d.instances) {
        point(copy.placement.origin);
        put(copy.step, copy.placement.clockwiseDeg, int{copy.placement.isMirrored}, int{copy.isFlipped});
    }
    for (const model::Net& net : d.nets) {
        text += net.name + ' ';
    }
    for (const std::string& symbol : d.symbols) {
        text += symbol + ' ';
    }
    for (const model::Diagnostic& entry : d.diagnostics.entries()) {
        text += entry.file + ':' + entry.text + ' ';
        put(entry.line, entry.count);
    }
    return text;
}

/// Is the point in the region? By the winding number of all loops.
inline bool covers(const model::PolygonSet& set, model::Point p) {
    int winding = 0;
    for (std::size_t l = 0; l < set.loopCount(); ++l) {
        const auto loop = set.loop(l);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const model::Point a = loop[i];
            const model::Point b = loop[(i + 1) % loop.size()];
            const __int128 side = static_cast<__int128>(b.x - std::int64_t{a.x}) * (p.y - std::int64_t{a.y}) -
                                  static_cast<__int128>(b.y - std::int64_t{a.y}) * (p.x - std::int64_t{a.x});
            winding += a.y <= p.y && b.y > p.y && side > 0 ? 1 : 0;
            winding -= a.y > p.y && b.y <= p.y && side < 0 ? 1 : 0;
        }
    }
    return winding > 0;
}

}  // namespace odb_testing
