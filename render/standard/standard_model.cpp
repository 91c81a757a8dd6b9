#include "render/standard/standard_model.h"

#include <algorithm>
#include <atomic>

#include "model/base/parallel.h"
#include "model/base/stopwatch.h"
#include "model/figures/element_polygons.h"
#include "model/geometry/boolean.h"
#include "render/modelling/area_meshes.h"

namespace render {

using model::Document;
using model::ElementId;
using model::PolygonSet;

namespace {

constexpr std::uint32_t kElementsPerPart = 1024;

/// What an outline needs beside its plain prism.
enum class Outline : std::uint8_t {
    Plain,
    MayTouchItself,  ///< of an area: opposite edges cancel (odb-notes, Features)
    WallOnly         ///< of an NPTH: there is nothing but its wall
};

/// A part on its path: outlines of its elements, then triangles.
struct Draft {
    std::uint32_t layer = 0;
    model::Range elements;
    PolygonSet outlines;
    std::vector<std::uint32_t> owner;  ///< by polygon: StandardVertex::owner
    std::vector<Outline> kind;         ///< by polygon
    std::vector<std::uint32_t> triangles;
    std::vector<std::uint32_t> next;  ///< by point, the end of its wall
};

void addOutlines(Draft& draft, const PolygonSet& set, std::uint32_t owner, Outline kind) {
    draft.outlines.append(set);
    draft.owner.resize(draft.outlines.polygons.size(), owner);
    draft.kind.resize(draft.outlines.polygons.size(), kind);
}

/// The wall of a hole is what lies between its outline and its opening; the opening itself is drawn dark. The tracks
/// of a routed path overlap: there the wall is left solid below the dark opening, as the lets do.
void addHole(Draft& draft, PolygonSet outline, const PolygonSet& opening, std::uint32_t element, bool isPath) {
    const bool isUnplated = !isPath && outline.points == opening.points;
    const bool isBarrel = !isPath && !isUnplated && !outline.polygons.empty();
    for (std::size_t loop = 0; loop < opening.loopCount() && isBarrel; ++loop) {
        outline.addLoop(opening.loop(loop));
    }
    addOutlines(draft, outline, element, isUnplated ? Outline::WallOnly : Outline::Plain);
    addOutlines(draft, opening, element | shader::kStandardBore, Outline::Plain);
}

void discretiseDraft(const Document& document, const model::Discretisation& how, Draft& draft) {
    for (std::uint32_t row = draft.elements.first; row < draft.elements.first + draft.elements.count; ++row) {
        const ElementId element{row};
        const model::ElementKind kind = document.elements.kind[row];
        const PolygonSet opening = model::discretiseOpening(document, element, how);
        if (opening.polygons.empty()) {
            const bool isArea = kind == model::ElementKind::Area;
            addOutlines(draft, model::discretise(document, element, how), row,
                        isArea ? Outline::MayTouchItself : Outline::Plain);
        } else {
            const bool isPath = kind == model::ElementKind::Arc || kind == model::ElementKind::Trail;
            addHole(draft, model::discretise(document, element, how), opening, row, isPath);
        }
    }
}

/// One polygon on its own.
PolygonSet polygonOf(const PolygonSet& set, std::size_t row) {
    PolygonSet alone;
    alone.beginPolygon();
    for (std::uint32_t i = 0; i < set.polygons[row].loopCount; ++i) {
        alone.addLoop(set.loop(set.polygons[row].firstLoop + i));
    }
    return alone;
}

/// Triangulates all outlines; one that crosses itself is repaired by integer booleans, as the hybrid pipeline does, and
/// its repaired polygons take its place at the end.
void triangulateDraft(Draft& draft) {
    const std::size_t given = draft.outlines.polygons.size();
    for (std::size_t row = 0; row < draft.outlines.polygons.size(); ++row) {
        if (draft.kind[row] == Outline::WallOnly) {
            continue;
        }
        if (!triangulatePolygon(draft.outlines, row, draft.triangles)) {
            if (row < given) {
                addOutlines(draft, model::unite(polygonOf(draft.outlines, row)), draft.owner[row],
                            Outline::MayTouchItself);
            }
            draft.outlines.polygons[row].loopCount = 0;
        }
    }
}

void addWalls(const PolygonSet& outlines, std::size_t row, Outline kind, std::vector<std::uint32_t>& next) {
    const PolygonSet::Polygon& polygon = outlines.polygons[row];
    const std::uint32_t first = outlines.loopStart[polygon.firstLoop];
    if (kind == Outline::MayTouchItself) {
        const std::vector<std::uint32_t> own = findWalls(polygonOf(outlines, row));
        std::ranges::transform(own, next.begin() + first, [&](std::uint32_t to) { return first + to; });
        return;
    }
    for (std::uint32_t loop = polygon.firstLoop; loop < polygon.firstLoop + polygon.loopCount; ++loop) {
        for (std::uint32_t i = outlines.loopStart[loop]; i < outlines.loopStart[loop + 1]; ++i) {
            next[i] = i + 1 < outlines.loopStart[loop + 1] ? i + 1 : outlines.loopStart[loop];
        }
    }
}

void findDraftWalls(Draft& draft) {
    draft.next.resize(draft.outlines.points.size());
    for (std::uint32_t i = 0; i < draft.next.size(); ++i) {
        draft.next[i] = i;
    }
    for (std::size_t row = 0; row < draft.outlines.polygons.size(); ++row) {
        if (draft.outlines.polygons[row].loopCount > 0) {
            addWalls(draft.outlines, row, draft.kind[row], draft.next);
        }
    }
}

/// Where the faces of an element lie between those of its layer (StandardVertex::face).
struct Faces {
    float lower = 0.0F;
    float upper = 1.0F;
};

Faces facesOf(const Document& document, ElementId element) {
    if (document.bodyOf(element) == nullptr) {
        return {};
    }
    const model::Layer& layer = document.layer(document.elements.layer[element.row()]);
    const model::ZRange z = document.heightsOf(element);
    const auto part = [&](model::Nm at) {
        return static_cast<float>(static_cast<double>(at - layer.z) / static_cast<double>(layer.thickness));
    };
    return {part(z.bottom), part(z.top)};
}

/// Vertex 2i is the upper, 2i + 1 the lower end of point i.
void addVertices(const Document& document, const Draft& draft, model::Point origin, StandardPart& part) {
    part.vertices.resize(2 * draft.outlines.points.size());
    for (std::size_t row = 0; row < draft.outlines.polygons.size(); ++row) {
        const PolygonSet::Polygon& polygon = draft.outlines.polygons[row];
        const std::uint32_t end = draft.outlines.loopStart[polygon.firstLoop + polygon.loopCount];
        const Faces faces = facesOf(document, ElementId{draft.owner[row] & ~shader::kStandardBore});
        for (std::uint32_t i = draft.outlines.loopStart[polygon.firstLoop]; i < end; ++i) {
            const glm::vec2 at = toGpu(base::toDouble(draft.outlines.points[i]), origin);
            part.vertices[2 * i] = {at.x, at.y, faces.upper, draft.owner[row]};
            part.vertices[2 * i + 1] = {at.x, at.y, faces.lower, draft.owner[row]};
        }
    }
}

StandardPart extrude(const Document& document, const Draft& draft, model::Point origin) {
    StandardPart part;
    part.layer = draft.layer;
    addVertices(document, draft, origin, part);
    part.indices.reserve(2 * draft.triangles.size() + 6 * draft.next.size());
    for (const std::uint32_t i : draft.triangles) {
        part.indices.push_back(2 * i);
    }
    for (std::size_t i = 0; i < draft.triangles.size(); i += 3) {
        for (const std::size_t corner : {i, i + 2, i + 1}) {
            part.indices.push_back(2 * draft.triangles[corner] + 1);
        }
    }
    for (std::uint32_t i = 0; i < draft.next.size(); ++i) {
        const std::uint32_t to = draft.next[i];
        if (to != i) {
            // Outlines run with the solid on their left: outside is on the right.
            part.indices.insert(part.indices.end(), {2 * to, 2 * i, 2 * i + 1, 2 * to, 2 * i + 1, 2 * to + 1});
        }
    }
    return part;
}

std::vector<Draft> makeDrafts(const Document& document) {
    std::vector<Draft> drafts;
    for (std::uint32_t layer = 0; layer < document.layers.size(); ++layer) {
        const model::Range all = document.layers[layer].elements;
        for (std::uint32_t done = 0; done < all.count; done += kElementsPerPart) {
            Draft& draft = drafts.emplace_back();
            draft.layer = layer;
            draft.elements = {all.first + done, std::min(kElementsPerPart, all.count - done)};
        }
    }
    return drafts;
}

/// Does `work` for every draft, on all cores; how long it took in `ms`.
template <class Work>
bool forDrafts(std::vector<Draft>& drafts, base::Progress& progress, std::string_view phase, double& ms,
               const Work& work) {
    const base::Stopwatch watch;
    progress.beginPhase(phase);
    std::atomic<std::size_t> done{0};
    base::parallelFor(drafts.size(), [&](std::size_t i) {
        if (!progress.isCancelled()) {
            work(i);
            progress.setFraction(static_cast<float>(++done) / static_cast<float>(drafts.size()));
        }
    });
    ms = watch.milliseconds();
    return !progress.isCancelled();
}

base::Result<StandardModel> buildStep(const Document& document, const model::Discretisation& how,
                                      base::Progress& progress) {
    StandardModel out;
    static_cast<BoardFrame&>(out) = frameOf(document);
    out.elementCount = static_cast<std::uint32_t>(document.elements.size());
    std::vector<Draft> drafts = makeDrafts(document);
    out.parts.resize(drafts.size());
    const bool isDone = forDrafts(drafts, progress, "Inflating tracks and rounding curves", out.times.discretiseMs,
                                  [&](std::size_t i) { discretiseDraft(document, how, drafts[i]); }) &&
                        forDrafts(drafts, progress, "Triangulating every element", out.times.triangulateMs,
                                  [&](std::size_t i) { triangulateDraft(drafts[i]); }) &&
                        forDrafts(drafts, progress, "Making walls", out.times.createMs, [&](std::size_t i) {
                            findDraftWalls(drafts[i]);
                            out.parts[i] = extrude(document, drafts[i], out.origin);
                            drafts[i] = {};
                        });
    if (!isDone) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    return out;
}

}  // namespace

std::uint64_t StandardModel::triangles() const {
    std::uint64_t sum = 0;
    for (const StandardPart& part : parts) {
        sum += part.indices.size() / 3;
    }
    for (const StandardModel& step : steps) {
        sum += step.triangles();
    }
    return sum;
}

base::Result<StandardModel> buildStandardModel(const Document& document, const model::Discretisation& how,
                                               base::Progress& progress) {
    return buildWithSteps<StandardModel>(document,
                                         [&](const Document& step) { return buildStep(step, how, progress); });
}

}  // namespace render
