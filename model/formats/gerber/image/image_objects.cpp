#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "model/base/limits.h"
#include "model/formats/gerber/image/image_parser.h"
#include "model/formats/gerber/text/words.h"
#include "model/geometry/outlines.h"
#include "model/geometry/slits.h"
#include "model/geometry/vectors.h"

namespace model::gerber {

using formats::DrawnFeature;
using formats::DrawnKind;

namespace {}  // namespace

// ---- operations ----

/// Coordinates as the whole image is mirrored and scaled.
ImageParser::Word ImageParser::onImage(Word word) const {
    const double a = m_isImageMirroredA ? -m_imageScale : m_imageScale;
    const double b = m_isImageMirroredB ? -m_imageScale : m_imageScale;
    word.x *= a;
    word.i *= a;
    word.y *= b;
    word.j *= b;
    return word;
}

bool ImageParser::isClockwise() const {
    return (m_mode == Mode::Clockwise) != (m_isImageMirroredA != m_isImageMirroredB);
}

void ImageParser::noteBeyond(base::PointD place) {
    base::PointD& corner = m_image.cornerBeyond;
    const bool isFirst = m_image.placesBeyond++ == 0;
    corner = isFirst ? place : base::PointD{std::min(corner.x, place.x), std::min(corner.y, place.y)};
}

void ImageParser::operate(const Word& read) {
    const Word word = onImage(read);
    int operation = word.operation;
    if (operation == 0) {
        operation = m_lastOperation;
        if (operation == 0) {
            return report(Severity::Warning, "coordinates before any operation; they were left out");
        }
        if (operation == 2 || operation == 3) {
            report(Severity::Info, "coordinates without an operation; the last one was repeated");
        }
    } else if (operation > 3) {
        return report(Severity::Warning, "an operation that does not exist; it was left out");
    }
    m_lastOperation = operation;
    const bool isIncremental = m_format.isIncremental;
    const double atX = !word.hasX ? m_position.x : word.x + (isIncremental ? m_position.x : m_format.shift.x);
    const double atY = !word.hasY ? m_position.y : word.y + (isIncremental ? m_position.y : m_format.shift.y);
    const std::optional<Nm> x = toNm(atX);
    const std::optional<Nm> y = toNm(atY);
    if (!x || !y) {
        m_isBad = true;
        noteBeyond({atX, atY});
        return report(Severity::Warning,
                      "a coordinate is larger than any board (1.07 m); what is drawn there is left out");
    }
    const Point to{*x, *y};
    if (operation == 1 && !m_isBad) {
        draw(to, word);
    } else if (operation == 2 && m_isInRegion) {
        endContour();
    }
    m_position = to;
    m_isBad = false;
    if (operation == 3) {
        flash();
    }
}

bool ImageParser::findCentre(Point to, const Word& word, Point& centre) {
    centre = centreOf(to, word);
    if (centre == m_position || centre == to) {
        if (to != m_position) {
            report(Severity::Warning, "an arc without a radius; taken as a straight line");
        }
        return false;
    }
    if (!isAbout(centre, to)) {
        report(Severity::Warning, "an arc whose ends are not equally far from its centre; drawn as a spiral");
    }
    return true;
}

/// Where the file says neither G74 nor G75, as old ones do, the arc is of whichever fits: I and J have signs or not.
Point ImageParser::centreOf(Point to, const Word& word) {
    const auto x = toNm(m_position.x + word.i);
    const auto y = toNm(m_position.y + word.j);
    const Point multi = x && y ? Point{*x, *y} : m_position;
    if (m_hasQuadrant && !m_isSingleQuadrant) {
        return multi;
    }
    const Point single = to == m_position ? m_position : singleQuadrantCentre(to, word);
    if (m_hasQuadrant) {
        return single;
    }
    const bool isSingle = single != m_position && !isAbout(multi, to) && isAbout(single, to);
    report(Severity::Info, isSingle ? "arcs without G74 or G75 before them; taken as G74, which fits their ends"
                                    : "arcs without G74 or G75 before them; taken as G75");
    return isSingle ? single : multi;
}

/// Are both ends of the arc equally far from there, but for the rounding of coarse formats?
bool ImageParser::isAbout(Point centre, Point to) const {
    const double from = distance(base::toDouble(centre), base::toDouble(m_position));
    const double until = distance(base::toDouble(centre), base::toDouble(to));
    return std::abs(from - until) <= std::max(0.05 * std::max(from, until), 50'000.0);
}

/// I and J come without signs: of the four centres the one that both ends are equally far from counts, for an arc of a
/// quarter turn at most.
Point ImageParser::singleQuadrantCentre(Point to, const Word& word) const {
    const PointD from = base::toDouble(m_position);
    const PointD until = base::toDouble(to);
    PointD best = from;
    double least = std::numeric_limits<double>::max();
    for (const double sx : {1.0, -1.0}) {
        for (const double sy : {1.0, -1.0}) {
            const PointD c{from.x + sx * std::abs(word.i), from.y + sy * std::abs(word.j)};
            const double cross = (from.x - c.x) * (until.y - c.y) - (from.y - c.y) * (until.x - c.x);
            const double dot = (from.x - c.x) * (until.x - c.x) + (from.y - c.y) * (until.y - c.y);
            const double turn = std::atan2(isClockwise() ? -cross : cross, dot);
            // Rounding may make a quarter turn a little more.
            const bool isQuarter = turn >= -1e-3 && turn <= std::numbers::pi / 2 + 0.02;
            const double miss = std::abs(distance(from, c) - distance(until, c)) + (isQuarter ? 0.0 : 1e12);
            if (miss < least) {
                least = miss;
                best = c;
            }
        }
    }
    return toNm(best.x) && toNm(best.y) ? rounded(best) : m_position;
}

void ImageParser::draw(Point to, const Word& word) {
    Point centre;
    const bool isArcDrawn = m_mode != Mode::Linear && findCentre(to, word, centre);
    if (m_isInRegion) {
        if (m_contour.empty()) {
            m_contour.push_back({m_position, {}, EdgeKind::Line});
            m_contourLine = m_line;
        }
        if (isArcDrawn) {
            m_contour.back().centre = centre;
            m_contour.back().edge = isClockwise() ? EdgeKind::ArcClockwise : EdgeKind::ArcCounterClockwise;
        } else if (to == m_position) {
            return;
        }
        m_contour.push_back({to, {}, EdgeKind::Line});
        return;
    }
    if (m_aperture == nullptr) {
        return select(m_selected);  // reports it
    }
    if (m_aperture->block >= 0) {
        return report(Severity::Warning, "a block cannot be drawn with, only flashed; it was left out");
    }
    DrawnFeature feature;
    feature.kind = isArcDrawn ? DrawnKind::Arc : DrawnKind::Line;
    feature.isClockwise = isClockwise();
    feature.symbol = m_flashed.isPlain()
                         ? m_aperture->symbol
                         : m_mover.turnedSymbol(m_mover.scaledSymbol(m_aperture->symbol, m_scale), m_flashed.placement);
    feature.a = m_position;
    feature.b = to;
    feature.centre = centre;
    m_attributes.apply(feature, m_aperture->attributes);
    ++m_image.draws;
    add(feature);
}

void ImageParser::flash() {
    if (m_isInRegion) {
        return report(Severity::Warning, "a flash within a region; it was left out");
    }
    if (m_aperture == nullptr) {
        return select(m_selected);
    }
    if (m_aperture->block >= 0) {
        return flashBlock(*m_aperture);
    }
    DrawnFeature feature;
    feature.kind = DrawnKind::Pad;
    feature.symbol = m_mover.scaledSymbol(m_aperture->symbol, m_scale);
    feature.a = m_position;
    feature.clockwiseDeg = m_flashed.placement.clockwiseDeg;
    feature.isMirrored = m_flashed.placement.isMirrored;
    m_attributes.apply(feature, m_aperture->attributes);
    ++m_image.flashes;
    add(feature);
}

bool ImageParser::mayExpand(std::size_t count) {
    if (count > base::kMostExpanded || m_expanded > base::kMostExpanded - count) {
        report(Severity::Error, "blocks or repeated steps draw " + base::moreThan(base::kMostExpanded, "objects") +
                                    "; the rest of them is left out");
        return false;
    }
    m_expanded += count;
    return true;
}

void ImageParser::flashBlock(const Aperture& aperture) {
    const std::vector<DrawnFeature>& block = m_blocks[static_cast<std::size_t>(aperture.block)];
    if (!mayExpand(block.size())) {
        return;
    }
    Transform transform = m_flashed;
    transform.placement.origin = m_position;
    transform.isInverted = m_isClear;
    std::vector<DrawnFeature>& target = sink();
    for (DrawnFeature feature : block) {
        if (!m_mover.move(feature, transform)) {
            report(Severity::Warning,
                   "a coordinate is larger than any board (1.07 m); what is drawn there is left out");
            continue;
        }
        target.push_back(feature);
    }
}

std::vector<DrawnFeature>& ImageParser::sink() {
    return m_frames.empty() ? m_image.features : m_frames.back().features;
}

void ImageParser::add(DrawnFeature feature) {
    feature.isNegative = m_isClear;
    feature.line = m_line;
    sink().push_back(feature);
}

// ---- regions ----

void ImageParser::beginRegion() {
    if (m_isInRegion) {
        report(Severity::Warning, "a region within a region; they are taken as one");
    }
    m_isInRegion = true;
}

void ImageParser::endRegion() {
    if (!m_isInRegion) {
        report(Severity::Warning, "the end of a region that was not begun");
    }
    endContour();
    m_isInRegion = false;
}

void ImageParser::endContour() {
    std::vector<PathNode> nodes = std::exchange(m_contour, {});
    if (nodes.size() < 2) {
        return;
    }
    if (nodes.back().point == nodes.front().point) {
        nodes.pop_back();
    } else {
        report(Severity::Info, "a contour that is not closed; closed by a straight line");
    }
    const bool isCircle = nodes.size() == 1 && nodes[0].edge != EdgeKind::Line;
    const bool hasArc = std::ranges::any_of(nodes, [](const PathNode& node) { return node.edge != EdgeKind::Line; });
    if (nodes.size() < 3 && !isCircle && !hasArc) {
        return report(Severity::Info, "a contour without an area; it was left out");
    }
    ShapeSketch sketch;
    sketch.beginContour(false);
    for (const PathNode& node : withOpeningsAgainst(withNodesWhereRunBack(std::move(nodes)))) {
        sketch.addNode(node);
    }
    DrawnFeature feature;
    feature.kind = DrawnKind::Region;
    feature.region = static_cast<std::int32_t>(m_image.regions.size());
    m_image.regions.push_back(std::move(sketch));
    m_attributes.apply(feature, m_attributes.apertureSet());
    ++m_image.contours;
    add(feature);
    sink().back().line = m_contourLine;
}

// ---- blocks and repeated steps ----

void ImageParser::endFrame() {
    Frame frame = std::move(m_frames.back());
    m_frames.pop_back();
    if (frame.isBlock) {
        m_apertures[frame.aperture] = {formats::kNoRow, static_cast<std::int32_t>(m_blocks.size()), frame.attributes};
        m_blocks.push_back(std::move(frame.features));
        return;
    }
    repeatFrame(frame);
}

void ImageParser::repeatFrame(const Frame& frame) {
    if (frame.features.empty()) {
        return;
    }
    for (int x = 0; x < frame.nx; ++x) {
        for (int y = 0; y < frame.ny; ++y) {
            if ((x > 0 || y > 0) && !mayExpand(frame.features.size())) {
                return;
            }
            const auto ox = toNm(x * frame.dx);
            const auto oy = toNm(y * frame.dy);
            if (!ox || !oy) {
                report(Severity::Warning,
                       "a repeated step lies beyond any board, more than 1.07 m from the origin; it is left out");
                break;  // those above lie farther yet
            }
            addMoved(frame.features, {*ox, *oy});
        }
    }
}

void ImageParser::addMoved(const std::vector<DrawnFeature>& features, Point by) {
    Transform transform;
    transform.placement.origin = by;
    std::vector<DrawnFeature>& target = sink();
    for (DrawnFeature feature : features) {
        if (m_mover.move(feature, transform)) {
            target.push_back(feature);
        } else {
            report(Severity::Warning,
                   "a coordinate is larger than any board (1.07 m); what is drawn there is left out");
        }
    }
}

void ImageParser::finish() {
    if (m_isInRegion) {
        report(Severity::Error, "the file ends within a region");
        endRegion();
    }
    while (!m_frames.empty()) {
        report(Severity::Warning, m_frames.back().isBlock
                                      ? "the file ends within a block"
                                      : "the file ends within a repeated step, which ends there too");
        endFrame();
    }
    if (!m_image.hasEnd) {
        report(Severity::Warning, "the file ends without M02: it may be cut off");
    }
    Transform turned;
    turned.placement = placementOf(false, false, m_imageRotation);
    if (m_isAxesSwapped) {  // which mirrors at the diagonal: x to -x, then a quarter turn clockwise
        turned.placement = placementOf(true, false, -90.0).after(turned.placement);
    }
    turned.placement.origin = turned.placement.apply(m_imageOffset);  // moved first, then turned
    if (!turned.isIdentity()) {
        const std::size_t gone =
            std::erase_if(m_image.features, [&](DrawnFeature& feature) { return !m_mover.move(feature, turned); });
        if (gone > 0) {
            report(Severity::Warning,
                   "what the image draws beyond any board, more than 1.07 m from the origin, is left out");
        }
    }
}

}  // namespace model::gerber
