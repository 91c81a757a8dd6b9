#include "model/formats/ipc2581/ipc_reader.h"

#include <algorithm>
#include <array>

#include "model/base/ascii.h"
#include "model/formats/common/archive_stream.h"
#include "model/formats/drawing/assembly.h"
#include "model/formats/ipc2581/job_steps.h"
#include "model/formats/ipc2581/xml/xml_values.h"

namespace model::ipc2581 {

namespace {

using formats::DrawnJob;

constexpr std::string_view kRoot = "IPC-2581";
constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
constexpr std::size_t kHeadBytes = 4096;
constexpr char kNewestKnown = 'C';
constexpr std::size_t kLongestRevision = 20;

base::Error badInput(const std::filesystem::path& path, const std::string& text) {
    return {base::ErrorCode::BadInput, path.string() + ": " + text};
}

/// Revisions are letters, some with a digit behind.
bool isNewer(std::string_view revision) {
    const std::string letter = base::lowerCase(revision.substr(0, 1));
    return letter > base::lowerCase(std::string(1, kNewestKnown)) && letter <= "z";
}

bool isUtf16(std::string_view text) {
    return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") ||
           text.substr(0, 2) == std::string_view("<\0", 2);
}

class JobReader {
public:
    JobReader(const XmlOutline& outline, const std::filesystem::path& path, base::Progress& progress)
        : m_path(path), m_progress(progress), m_reading(outline, path.filename().string(), m_job.diagnostics) {}

    base::Result<DrawnJob> read(const std::string& wantedStep) {
        const XmlOutline& outline = m_reading.outline();
        if (!outline.fault.empty()) {
            m_reading.report(
                Severity::Error, outline.faultLine,
                "no sound XML from here on (" + std::string(outline.fault) + "); what comes before is shown");
        }
        describe();
        setUnits();
        reportOthers();
        const Dictionaries dictionaries(m_reading);
        const Specs specs(m_reading);
        formats::DrawnStep scratch;
        Canvas canvas(m_reading, scratch);
        ShapeReader shapes(m_reading, dictionaries, canvas);
        LayerList layers(m_reading, specs, shapes);
        const Stackups stackups = readStackups(m_reading, specs, layers);
        const Bom bom(m_reading);
        std::vector<SourceStep> steps = readSteps({m_reading, dictionaries, specs, layers, stackups, bom, m_progress});
        if (m_progress.isCancelled()) {
            return base::Error{base::ErrorCode::Cancelled, "cancelled"};
        }
        if (steps.empty()) {
            return badInput(m_path, outline.fault.empty()
                                        ? "the file has no Step in its CadData: there is no board in it"
                                        : "no sound XML from line " + std::to_string(outline.faultLine) + " on (" +
                                              std::string(outline.fault) + "), and no board before it");
        }
        const base::Result<std::size_t> shown = choose(steps, wantedStep);
        if (!shown) {
            return shown.error();
        }
        m_job.boardNm = stackups.boardNm;
        const std::vector<std::int32_t> rows = orderLayers(m_reading, layers, stackups.order, m_job.layers);
        addSteps(m_reading, std::move(steps), *shown, rows, m_job);
        return std::move(m_job);
    }

private:
    void describe() {
        m_job.info.name = m_path.stem().string();
        m_job.info.version = std::string(kRoot);
        for (const XmlSection& section : m_reading.outline().sections) {
            XmlCursor at = m_reading.at(section);
            if (section.depth == 1) {
                at.next();
                const std::string revision = textOf(at.value("revision"));
                m_job.info.version += revision;
                if (isNewer(revision)) {
                    m_reading.report(Severity::Warning, section.line,
                                     "the file is of revision " + revision.substr(0, kLongestRevision) +
                                         ", newer than what is known (C); what is new in it is not read");
                }
            } else if (section.name == "SoftwarePackage" && m_job.info.generator.empty()) {
                at.next();
                m_job.info.generator = textOf(at.value("name")) + " " + textOf(at.value("revision"));
            }
        }
    }

    void setUnits() {
        std::string_view units;
        std::uint32_t line = 0;
        for (const XmlSection& section : m_reading.outline().sections) {
            if (section.name == "CadHeader") {
                XmlCursor at = m_reading.at(section);
                at.next();
                units = at.value("units");
                line = section.line;
                break;
            }
        }
        const double nm = unitNamed(units);
        if (nm == 0.0) {
            m_reading.report(Severity::Warning, line,
                             "the CadHeader names no units that are known; millimetres are assumed");
        }
        m_reading.setUnitNm(nm > 0.0 ? nm : base::kNmPerMm);
        m_job.info.units = nm == base::kNmPerInch || nm == base::kNmPerMil ? "INCH" : "MM";
    }

    /// What lies where the parts of the file lie that are read.
    void reportOthers() {
        static constexpr std::array<std::string_view, 4> kParents = {kRoot, "Ecad", "CadHeader", "CadData"};
        // LogisticHeader, HistoryRecord and ChangeRec say who made the file, nothing of the board.
        static constexpr std::array<std::string_view, 12> kKnown = {
            "Content", "LogisticHeader", "HistoryRecord", "Bom",     "Ecad", "CadHeader",
            "CadData", "Spec",           "ChangeRec",     "Stackup", "Step", "Layer"};
        const auto has = [](const auto& names, std::string_view name) {
            return std::ranges::find(names, name) != names.end();
        };
        std::array<std::string_view, kOutlineDepth + 1> open{};
        for (const XmlSection& section : m_reading.outline().sections) {
            const auto depth = static_cast<std::size_t>(section.depth);
            open[depth] = section.name;
            if (has(kParents, open[depth - 1]) && !has(kKnown, section.name) && !isOfStep(section.name)) {
                XmlCursor at = m_reading.at(section);
                at.next();
                m_reading.reportUnknown(at);
            }
        }
    }

    /// Steps with the sections below them. Parts of a step that lie elsewhere go to the first one.
    std::vector<SourceStep> readSteps(const StepSurroundings& file) {
        struct Sections {
            std::string_view name;
            std::vector<XmlSection> below;
        };
        std::vector<Sections> found;
        std::vector<XmlSection> stray;
        int stepDepth = 0;  // 0: outside of steps
        for (const XmlSection& section : m_reading.outline().sections) {
            if (stepDepth > 0 && section.depth <= stepDepth) {
                stepDepth = 0;
            }
            if (stepDepth == 0 && section.name == "Step") {
                XmlCursor at = m_reading.at(section);
                at.next();
                found.push_back({at.value("name"), {}});
                stepDepth = section.depth;
            } else if (stepDepth > 0 && section.depth == stepDepth + 1) {
                found.back().below.push_back(section);
            } else if (stepDepth == 0 && isOfStep(section.name)) {
                stray.push_back(section);
            }
        }
        if (!stray.empty() && !found.empty()) {
            m_reading.report(Severity::Warning, stray.front().line,
                             "parts of a step lie outside of steps; they are read as those of the first one");
            found.front().below.insert(found.front().below.end(), stray.begin(), stray.end());
        }
        std::vector<SourceStep> steps;
        for (const Sections& sections : found) {
            m_progress.setFraction(static_cast<float>(steps.size()) / static_cast<float>(found.size()));
            if (!m_progress.isCancelled()) {
                steps.push_back(readStep(file, sections.name, sections.below));
            }
        }
        return steps;
    }

    static bool isOfStep(std::string_view name) {
        return name == "LogicalNet" || name == "PhyNetGroup" || name == "LayerFeature" || name == "Component" ||
               name == "Package" || name == "PadStack";
    }

    base::Result<std::size_t> choose(const std::vector<SourceStep>& steps, const std::string& wanted) const {
        const auto found = std::ranges::find_if(steps, [&](const SourceStep& step) {
            return wanted.empty() ? step.drawsItself : base::lowerCase(step.drawn.name) == base::lowerCase(wanted);
        });
        if (found != steps.end()) {
            return static_cast<std::size_t>(found - steps.begin());
        }
        if (wanted.empty()) {
            return std::size_t{0};
        }
        std::string list;
        for (const SourceStep& step : steps) {
            list += (list.empty() ? "" : ", ") + step.drawn.name;
        }
        return base::Error{base::ErrorCode::BadUsage,
                           m_path.string() + ": the job has no step \"" + wanted + "\"; it has: " + list};
    }

    const std::filesystem::path& m_path;
    base::Progress& m_progress;
    DrawnJob m_job;
    Reading m_reading;
};

/// The rows of an archive that may be such files, by their names.
std::vector<int> candidates(const formats::Archive& archive) {
    static constexpr std::array<std::string_view, 4> kEndings = {".xml", ".cvg", ".xml.gz", ".cvg.gz"};
    std::vector<int> rows;
    for (const auto& [path, row] : archive.rows()) {
        if (std::ranges::any_of(kEndings, [&path = path](std::string_view e) { return path.ends_with(e); }) ||
            archive.size() == 1) {
            rows.push_back(row);
        }
    }
    return rows;
}

/// The text of a file of an archive, if it looks like IPC-2581.
std::optional<formats::Bytes> ipcText(const formats::Archive& archive, int row) {
    base::Result<formats::Bytes> bytes = archive.bytes(row);
    if (bytes) {
        bytes = formats::decodeMember(std::move(*bytes));
    }
    if (!bytes || !looksLikeIpc2581(bytes->view())) {
        return std::nullopt;
    }
    return std::move(*bytes);
}

/// What stands in quotes after `key` in the text; empty if it is not there.
std::string_view quotedAfter(std::string_view text, std::string_view key) {
    const std::size_t at = text.find(key);
    const std::size_t begin = at == std::string_view::npos ? at : text.find('"', at + key.size());
    const std::size_t end = begin == std::string_view::npos ? begin : text.find('"', begin + 1);
    return end == std::string_view::npos ? std::string_view() : text.substr(begin + 1, end - begin - 1);
}

/// "revision C, by KiCad EDA": the root says the one, the history at the end or at the beginning the other.
std::string contentsOf(std::string_view text) {
    const std::string_view root = text.substr(std::min(text.find("<IPC-2581"), text.size())).substr(0, kHeadBytes);
    const std::string_view revision = quotedAfter(root, "revision=");
    const std::size_t software = text.find("<SoftwarePackage");
    const std::string_view writer = software == std::string_view::npos
                                        ? std::string_view()
                                        : quotedAfter(text.substr(software, kHeadBytes), " name=");
    std::string contents = revision.empty() ? "no revision" : "revision " + std::string(revision);
    return writer.empty() ? contents : contents + ", by " + std::string(writer);
}

}  // namespace

bool looksLikeIpc2581(std::string_view head) {
    head.remove_prefix(head.starts_with(kUtf8Mark) ? kUtf8Mark.size() : 0);
    head = head.substr(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
    if (isUtf16(head)) {
        constexpr std::string_view kWide("I\0P\0C\0-\0002\0005\0008\0001", 15);
        return head.substr(0, kHeadBytes).find(kWide) != std::string_view::npos;
    }
    return head.starts_with('<') && head.substr(0, kHeadBytes).find(kRoot) != std::string_view::npos;
}

std::vector<formats::FormPart> filesIn(const formats::Archive& archive) {
    std::vector<formats::FormPart> files;
    for (const int row : candidates(archive)) {
        if (const std::optional<formats::Bytes> text = ipcText(archive, row)) {
            files.push_back({archive.path(row), contentsOf(text->view())});
        }
    }
    std::ranges::stable_sort(files, std::ranges::greater(), [](const formats::FormPart& file) {
        return file.contents.substr(0, file.contents.find(','));
    });
    return files;
}

base::Result<DrawnJob> parseJob(std::string_view text, const std::filesystem::path& path,
                                const formats::ReadOptions& options, base::Progress& progress) {
    if (isUtf16(text)) {
        return badInput(path, "the file is written in UTF-16; convert it to UTF-8");
    }
    progress.beginPhase("Reading the file");
    const XmlOutline outline = outlineOf(text, progress);
    if (outline.hasDocumentType) {
        return badInput(path, "line " + std::to_string(outline.faultLine) + ": " + std::string(outline.fault));
    }
    if (outline.sections.empty() || outline.sections[0].name != kRoot) {
        return badInput(path, "the file is no IPC-2581: it does not begin with such an element");
    }
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    progress.beginPhase("Reading layers");
    return JobReader(outline, path, progress).read(options.step);
}

base::Result<std::shared_ptr<const Document>> readJob(std::string_view text, const std::filesystem::path& path,
                                                      const formats::ReadOptions& options, const Diagnostics& unpacking,
                                                      base::Progress& progress, const base::Stopwatch& reading) {
    base::Result<DrawnJob> job = parseJob(text, path, options, progress);
    if (!job) {
        return job.error();
    }
    Diagnostics diagnostics = unpacking;
    diagnostics.append(job->diagnostics);
    job->diagnostics = std::move(diagnostics);
    return formats::assemble(*std::move(job), reading.milliseconds(), progress);
}

base::Result<std::shared_ptr<const Document>> readJob(const formats::Archive& archive,
                                                      const std::filesystem::path& path,
                                                      const formats::ReadOptions& options, const Diagnostics& unpacking,
                                                      base::Progress& progress, const base::Stopwatch& reading) {
    std::optional<formats::Bytes> first;
    std::filesystem::path name = path;
    Diagnostics diagnostics = unpacking;
    for (const int row : candidates(archive)) {
        std::optional<formats::Bytes> text = ipcText(archive, row);
        if (text && first) {
            diagnostics.report(Severity::Info, archive.path(row), 0,
                               "the first IPC-2581 file is shown; this is another one");
        } else if (text) {
            first = std::move(text);
            name = archive.path(row);
        }
    }
    if (!first) {
        return badInput(path, "there is no IPC-2581 file in it");
    }
    return readJob(first->view(), name, options, diagnostics, progress, reading);
}

}  // namespace model::ipc2581
