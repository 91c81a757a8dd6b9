#include "render/culling/frame_plan.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numeric>

#include "render/culling/shadowed_layers.h"

namespace render {
namespace {

// A polygon's outline strays less than this from the true one. The coarsest level that does so is drawn: changes of
// level are then below what an eye sees, and a raster of a layer (mono) is right to a tenth of a pixel.
constexpr float kTolerancePx = 0.3F;
constexpr float kMonoTolerancePx = 0.1F;
constexpr float kCoarseTolerancePx = 2.0F;
/// Lets whose pen radius is below this many pixels become quads (vulkan-facts, recipes).
constexpr float kQuadRadiusPx = 0.7F;
/// The inside of a hole protrudes by 2 µm, or by 16 steps of tie-break where depth resolves less: enough to win
/// against all faces it passes, too little to be seen.
constexpr float kBoreProtrusionMm = 0.002F;
constexpr float kBoreProtrusionSteps = 16.0F;

/// One step of tie-break between faces in one plane, in units of depth: 16 roundings of a 24-bit number. In perspective
/// depth is near / distance, relative steps do; in parallel projection depth is linear and rounds like the largest
/// number in it.
constexpr float kNudgePerspective = 0x1p-20F;
constexpr float kNudgeParallel = 0x1p-21F;
/// Pixel positions are rounded too: to about 2^-15 px on the software device, whose depths of slivers (a board's
/// outline is 1000 times as long as wide) were seen to stray by that share of depth range over width in pixels.
constexpr float kPositionRoundingPx = 0x1p-15F;

/// Steps by which a picture in a plane is nearer than that: more than any tie-break, and than the insides of holes.
constexpr double kPlaneSteps = 32.0;
/// From the middle of a pixel, where it is smoothed.
constexpr glm::dvec2 kFirstSample(-0.125, -0.375);

/// Where the light comes from, seen from above: from over the left shoulder.
const glm::vec2 kLight = glm::normalize(glm::vec2(-0.55F, 0.83F));

/// Where the lamp that glossy surfaces mirror stands: to the left, and up, for each step beyond the board.
constexpr float kLampAside = 0.6F;
constexpr float kLampHeight = 1.7F;

/// Larger than this the sine of the view angle to the board counts as straight.
constexpr float kStraight = 0.9999995F;

struct Eye {
    glm::dmat4 clipFromCentred{1.0};  ///< of positions relative to the camera's target
    float stepMm = 0.0F;              ///< one step of tie-break at the target
    glm::vec3 position{0.0F};
    glm::vec3 direction{0.0F};
    bool isParallel = false;
};

Eye makeEye(const Camera& camera, float aspect) {
    Eye eye;
    eye.position = camera.eye();
    eye.direction = camera.direction();
    eye.isParallel = camera.isOrthographic();
    // The view matrix about the target instead of the origin: no large numbers that cancel.
    glm::dmat4 view{camera.view()};
    view[3] = view * glm::dvec4(glm::dvec3(camera.target()), 1.0);
    const glm::mat4 projection = camera.projection(aspect);
    eye.clipFromCentred = glm::dmat4(projection) * view;
    eye.stepMm = eye.isParallel ? kNudgeParallel / std::abs(projection[2][2])
                                : kNudgePerspective * glm::length(eye.position - camera.target());
    return eye;
}

constexpr std::uint32_t kUneven = shader::kLayerGrowsUp | shader::kLayerGrowsDown;

bool isUneven(const shader::LayerState& layer) {
    return (layer.flags & kUneven) != 0;
}

/// Level faces are seen from one side whatever the pixel. From inside a solid neither is: its back would only fight
/// with what it touches.
SeenFaces seenFaces(const Eye& eye, const shader::LayerState& layer) {
    if (eye.isParallel) {
        const float z = eye.direction.z;
        return {z<0.0F, std::abs(z) < kStraight, z> 0.0F};
    }
    // Where heights differ, a face that is seen may lie anywhere in the layer: lids of parts that are low, undersides
    // of those that stand on others.
    const float upper = isUneven(layer) ? layer.z0 : layer.z1;
    const float lower = isUneven(layer) ? layer.z1 : layer.z0;
    return {eye.position.z > upper, true, eye.position.z < lower};
}

std::vector<SeenFaces> facesOfLayers(const Eye& eye, std::span<const shader::LayerState> layers) {
    std::vector<SeenFaces> faces;
    std::transform(layers.begin(), layers.end(), std::back_inserter(faces),
                   [&](const shader::LayerState& layer) { return seenFaces(eye, layer); });
    return faces;
}

/// Walls too low to show are not drawn, if the layer's face is.
void dropThinWalls(float pixelsPerMm, LayerPlan& plan) {
    for (std::size_t i = 0; i < plan.faces.size(); ++i) {
        SeenFaces& faces = plan.faces[i];
        const bool isThin = (plan.states[i].z1 - plan.states[i].z0) * pixelsPerMm < kThinPx;
        faces.walls = faces.walls && !(isThin && (faces.upper || faces.lower));
    }
}

/// What is seen of any visible layer. Seen edge-on neither face shows: walls alone are no run that starts or ends the
/// tables, so all are drawn.
SeenFaces seenOfAny(const FramePlan& plan) {
    SeenFaces all{false, false, false};
    for (const LayerPlan* layers : {&plan.upright, &plan.flipped}) {
        for (std::size_t i = 0; i < layers->states.size(); ++i) {
            const SeenFaces& faces = layers->faces[i];
            if ((layers->states[i].flags & shader::kLayerVisible) != 0) {
                all = {all.upper || faces.upper, all.walls || faces.walls, all.lower || faces.lower};
            }
        }
    }
    return all.upper || all.lower ? all : SeenFaces{};
}

/// By how much a film of solder mask takes its own hue from what passes through it.
constexpr float kTint = 0.75F;

/// Glossy films are stained glass, everything else a veil. Dimmed, all are veils: what is under them is of the
/// background's colour, and has to stay so.
glm::vec3 passedBy(const LayerStyle& style, float restStrength) {
    const glm::vec3 colour = toLinear(style.colour);
    const float most = std::max({colour.r, colour.g, colour.b, 1e-3F});
    const bool isFilm = style.material == Material::Gloss;
    const glm::vec3 hue = isFilm ? glm::mix(glm::vec3(1.0F), colour / most, kTint * restStrength) : glm::vec3(1.0F);
    return (1.0F - std::clamp(style.opacity, 0.0F, 1.0F)) * hue;
}

float restStrengthOf(const ViewSettings& settings) {
    return 1.0F - std::clamp(settings.dim, 0.0F, 1.0F);
}

glm::vec4 linearColour(const LayerStyle& style) {
    return {toLinear(style.colour), std::clamp(style.opacity, 0.0F, 1.0F)};
}

std::vector<shader::LayerState> layerStates(const SceneLayers& scene, const ViewSettings& settings, Subject subject) {
    const std::vector<ZRange> z = drawnHeights(scene, settings);
    std::vector<shader::LayerState> states(scene.layers.size());
    for (std::size_t i = 0; i < states.size(); ++i) {
        const LayerStyle& style = scene.styles[i];
        const bool isTranslucent = style.opacity < 1.0F && !settings.isMono && subject == Subject::Board;
        states[i].colour = linearColour(style);
        states[i].z0 = z[i].z0;
        states[i].z1 = z[i].z1;
        states[i].flags = (style.isVisible ? shader::kLayerVisible : 0) |
                          (isTranslucent ? shader::kLayerTranslucent : 0) | scene.layers[i].growth |
                          static_cast<std::uint32_t>(style.material) << shader::kLayerMaterialShift;
    }
    return states;
}

/// How bright what stands out is: `brightest` with no copper over it, darker with each layer more, by the share that is
/// left of what is above `darkest`.
struct DepthShades {
    float brightest;
    float darkest;
    float perCopper;
};
constexpr DepthShades kSolidShades{0.8F, 0.3F, 0.62F};  // leaves room for what is mirrored
constexpr DepthShades kFlatShades{1.0F, 0.35F, 0.45F};

/// Through the openings of a plane one sees how deep the next one is, and in 2D what lies over a plane of its own net.
/// The first steps are the largest.
void shadeByDepth(const SceneLayers& scene, bool is2d, bool isSeenFromAbove, std::vector<shader::LayerState>& states) {
    const auto& [brightest, darkest, perCopper] = is2d ? kFlatShades : kSolidShades;
    const auto height = [&](std::uint32_t i) { return isSeenFromAbove ? states[i].z1 : -states[i].z0; };
    std::vector<std::uint32_t> copper;
    for (std::uint32_t i = 0; i < states.size(); ++i) {
        states[i].colour.a = brightest;
        if (scene.layers[i].isCopper && (states[i].flags & shader::kLayerVisible) != 0) {
            copper.push_back(i);
        }
    }
    std::ranges::stable_sort(copper, std::greater(), height);
    float rest = 1.0F;
    for (const std::uint32_t i : copper) {
        states[i].colour.a = darkest + (brightest - darkest) * rest;
        rest *= perCopper;
    }
}

/// Among visible layers with a face at the same height, later layers win: they get higher ranks.
void rankFaces(std::vector<shader::LayerState>& layers, float shader::LayerState::*face, std::uint32_t shift) {
    std::vector<std::uint32_t> order(layers.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return layers[a].*face < layers[b].*face; });
    std::uint32_t rank = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        shader::LayerState& layer = layers[order[i]];
        const bool isShared = i > 0 && layers[order[i - 1]].*face == layer.*face;
        const bool counts = i > 0 && (layers[order[i - 1]].flags & shader::kLayerVisible) != 0;
        rank = isShared ? rank + (counts ? 1 : 0) : 0;
        layer.flags |= std::min(rank, 0xffU) << shift;
    }
}

/// Visible layers, opaque or translucent ones, the one farthest from the viewer first.
std::vector<std::uint32_t> visibleFromBack(const std::vector<shader::LayerState>& layers, bool isTranslucent,
                                           bool isSeenFromAbove) {
    constexpr std::uint32_t kRelevant = shader::kLayerVisible | shader::kLayerTranslucent;
    const std::uint32_t wanted = shader::kLayerVisible | (isTranslucent ? shader::kLayerTranslucent : 0);
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < layers.size(); ++i) {
        if ((layers[i].flags & kRelevant) == wanted) {
            order.push_back(i);
        }
    }
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
        return isSeenFromAbove ? layers[a].z1 < layers[b].z1 : layers[a].z0 > layers[b].z0;
    });
    return order;
}

std::vector<LayerBatch> makeBatches(std::vector<shader::LayerState>& layers, bool isSeenFromAbove) {
    std::vector<LayerBatch> batches(1);
    const auto add = [&](std::size_t batch, std::uint32_t layer) {
        layers[layer].batch = static_cast<std::uint32_t>(batch);
        batches[batch].push_back(layer);
    };
    // Opaque ones from the front: what they hide is not shaded.
    std::vector<std::uint32_t> opaque = visibleFromBack(layers, false, isSeenFromAbove);
    std::reverse(opaque.begin(), opaque.end());
    for (const std::uint32_t layer : opaque) {
        add(0, layer);
    }
    for (const std::uint32_t layer : visibleFromBack(layers, true, isSeenFromAbove)) {
        batches.emplace_back();
        add(batches.size() - 1, layer);
    }
    return batches;
}

/// The heights of visible layers, from the lowest to the highest.
ZRange visibleHeights(std::span<const shader::LayerState> states) {
    ZRange all{1e30F, -1e30F};
    for (const shader::LayerState& state : states) {
        if ((state.flags & shader::kLayerVisible) != 0) {
            all = {std::min(all.z0, state.z0), std::max(all.z1, state.z1)};
        }
    }
    return all;
}

LayerPlan planLayers(const SceneLayers& scene, const ViewSettings& settings, const Eye& eye, const EyePoint& point,
                     Subject subject, const ShadowedLayers& shadows) {
    LayerPlan plan;
    plan.states = layerStates(scene, settings, subject);
    shadows.mark(plan.states);
    rankFaces(plan.states, &shader::LayerState::z0, shader::kLayerBottomRankShift);
    rankFaces(plan.states, &shader::LayerState::z1, shader::kLayerTopRankShift);
    const ZRange heights = visibleHeights(plan.states);
    const bool showsInside = settings.section != nullptr && !settings.section->faces.empty() && !settings.is2d;
    const bool leavesOut = settings.cull && !scene.inSubstrate.empty() && !showsInside;
    const Sight sight = leavesOut ? sightOf(point, heights.z0, heights.z1) : Sight{};
    if (leavesOut && subject == Subject::Board) {
        hideBuried(scene.inSubstrate, sight, plan.states);
    }
    if (subject == Subject::StandingOut) {
        shadeByDepth(scene, settings.is2d, eye.direction.z <= 0.0F, plan.states);
    }
    plan.batches = makeBatches(plan.states, eye.direction.z <= 0.0F);
    plan.faces = facesOfLayers(eye, plan.states);
    for (const LayerStyle& style : scene.styles) {
        plan.passed.push_back(passedBy(style, restStrengthOf(settings)));
    }
    if (leavesOut && !settings.isMono) {
        dropThinWalls(sight.pixelsPerMm, plan);
    }
    return plan;
}

/// Flipped, a layer is drawn as the one it lies on; one without a counterpart keeps its style and lies at its mirror
/// image: `faces` (drawnFaces) minus where it is.
LayerPlan flippedPlan(const SceneLayers& scene, float faces, const LayerPlan& upright, const Eye& eye,
                      const ShadowedLayers& shadows) {
    LayerPlan plan;
    plan.batches.resize(upright.batches.size());
    for (std::uint32_t row = 0; row < scene.layers.size(); ++row) {
        const model::LayerId opposite = scene.layers[row].opposite;
        shader::LayerState state = upright.states[opposite.isValid() ? opposite.row() : row];
        if (!opposite.isValid()) {
            state.z0 = faces - upright.states[row].z1;
            state.z1 = faces - upright.states[row].z0;
            state.flags ^= isUneven(state) ? kUneven : 0;
            shadows.markMirrored(row, state);
        }
        if ((state.flags & shader::kLayerVisible) != 0) {
            plan.batches[state.batch].push_back(row);
        }
        plan.states.push_back(state);
    }
    plan.faces = facesOfLayers(eye, plan.states);
    return plan;
}

/// Planes of the frustum as combinations of the matrix rows, scaled to millimetres: 0 <= z <= w, -w <= x, y <= w.
void setPlanes(const glm::dmat4& clip, shader::FrameData& data) {
    const glm::dmat4 rows = glm::transpose(clip);
    const glm::dvec4 planes[shader::kPlaneCount] = {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1],
                                                    rows[3] - rows[1], rows[2],           rows[3] - rows[2]};
    for (std::uint32_t i = 0; i < shader::kPlaneCount; ++i) {
        // The far plane of an infinite projection has no normal; its constant is positive, so it cuts nothing off.
        const double length = glm::length(glm::dvec3(planes[i]));
        data.planes[i] = glm::vec4(planes[i] / (length > 0.0 ? length : 1.0));
    }
}

/// Where sight through a pixel starts: the picture as a rectangle at the camera's target.
void setScreen(const glm::dmat4& clip, double width, double height, shader::FrameData& data) {
    const glm::dmat4 back = glm::inverse(clip);
    const glm::dvec4 target = clip[3];
    const auto at = [&](double x, double y) {
        const glm::dvec4 location = back * glm::dvec4(x, y, target.z / target.w, 1.0);
        return glm::dvec3(location) / location.w;
    };
    const glm::dvec3 corner = at(-1.0, -1.0);
    data.screen = glm::vec3(corner);
    data.screenRight = glm::vec3((at(1.0, -1.0) - corner) / width);
    data.screenDown = glm::vec3((at(-1.0, 1.0) - corner) / height);
}

std::uint32_t flagsOf(const ViewSettings& settings) {
    return (settings.is2d ? shader::kFrameFlat : 0) | (settings.isMono ? shader::kFrameMono : 0) |
           (settings.cull ? shader::kFrameCull : 0) | (settings.isFabricated ? shader::kFrameFabricated : 0) |
           (settings.levels == LevelOfDetail::Paper ? shader::kFramePaperLevels : 0);
}

float toleranceOf(const ViewSettings& settings) {
    if (settings.isMono) {
        return kMonoTolerancePx;
    }
    return settings.levels == LevelOfDetail::Coarse ? kCoarseTolerancePx : kTolerancePx;
}

void setTriangleRun(SeenFaces faces, shader::FrameData& data) {
    data.firstTriangle = faces.upper   ? 0
                         : faces.walls ? shader::kUpperTriangles
                                       : shader::kUpperTriangles + shader::kWallTriangles;
    data.triangleCount = (faces.upper ? shader::kUpperTriangles : 0) + (faces.walls ? shader::kWallTriangles : 0) +
                         (faces.lower ? shader::kUpperTriangles : 0);
    data.quadFace = faces.upper ? 0 : 1;
}

/// A lamp that follows the camera: seen from wherever, it stands beyond the board and to its left, so high that
/// neither straight views nor tilted ones miss its glow.
glm::vec3 keyLightOf(const Eye& eye, const shader::FrameData& data) {
    const glm::vec2 right = glm::normalize(glm::vec2(data.screenRight) + glm::vec2(1e-9F, 0.0F));
    const glm::vec2 beyond = glm::vec2(eye.direction) - glm::vec2(glm::normalize(data.screenDown));
    const glm::vec2 to = glm::normalize(glm::normalize(beyond + glm::vec2(0.0F, 1e-9F)) - kLampAside * right);
    return glm::normalize(glm::vec3(to, eye.direction.z > 0.0F ? -kLampHeight : kLampHeight));
}

/// Left of the plane's line, for places relative to the camera's target.
glm::vec3 sectionOf(const SectionPlane& plane, const glm::vec3& centre) {
    const glm::dvec2 left(-plane.direction.y, plane.direction.x);
    return {left, glm::dot(left, plane.start - glm::dvec2(centre))};
}

}  // namespace

glm::vec3 backgroundOf(const ViewSettings& settings) {
    return toLinear(settings.isMono ? glm::vec3(0.0F) : settings.background);
}

FramePlan shifted(FramePlan plan, glm::vec2 pixels) {
    shader::FrameData& data = plan.data;
    glm::mat4 rows = glm::transpose(data.clipFromBoard);
    rows[0] += 2.0F * pixels.x / static_cast<float>(data.width) * rows[3];
    rows[1] += 2.0F * pixels.y / static_cast<float>(data.height) * rows[3];
    data.clipFromBoard = glm::transpose(rows);
    data.screen -= pixels.x * data.screenRight + pixels.y * data.screenDown;
    return plan;
}

std::optional<glm::vec3> depthOfPlane(const Camera& camera, float z, std::uint32_t width, std::uint32_t height,
                                      bool isSmoothed) {
    const Eye eye = makeEye(camera, static_cast<float>(width) / static_cast<float>(height));
    const glm::dmat4& clip = eye.clipFromCentred;
    // Of points (x, y, 1) of the plane; in it depth is a sum of shares of the two others and of the weight.
    const glm::dmat3x4 onPlane(clip[0], clip[1], clip[2] * double{z - camera.target().z} + clip[3]);
    const glm::dmat4x3 rows = glm::transpose(onPlane);
    const glm::dmat3 others(rows[0], rows[1], rows[3]);
    if (std::abs(glm::determinant(others)) < 1e-12) {
        return std::nullopt;
    }
    glm::dvec3 share = glm::inverse(others) * rows[2];
    share *= eye.isParallel ? 1.0 : 1.0 + kPlaneSteps * kNudgePerspective;
    share.z += eye.isParallel ? kPlaneSteps * kNudgeParallel : 0.0;
    const glm::dvec2 perPixel = glm::dvec2(share) * 2.0 / glm::dvec2(width, height);
    const glm::dvec2 sample = isSmoothed ? kFirstSample : glm::dvec2(0.0);
    return glm::vec3(glm::dvec3(perPixel, share.z - share.x - share.y + glm::dot(perPixel, sample)));
}

bool isFlatView(const FramePlan& plan) {
    const bool isParallel = plan.data.eye.w == 0.0F;
    return isParallel && !plan.faces.walls && plan.faces.upper != plan.faces.lower;
}

FramePlan planFrame(const SceneLayers& scene, const Camera& camera, const ViewSettings& settings, std::uint32_t width,
                    std::uint32_t height, Subject subject) {
    const auto pixelHeight = static_cast<float>(height);
    const Eye eye = makeEye(camera, static_cast<float>(width) / pixelHeight);
    const float pixelsPerMm = std::abs(camera.projection(1.0F)[1][1]) * pixelHeight / 2.0F;
    FramePlan plan;
    const float faces = drawnFaces(scene, settings);
    plan.isFromAbove = eye.isParallel ? eye.direction.z <= 0.0F : eye.position.z > 0.5F * faces;
    const ShadowedLayers shadows(scene, settings, plan.isFromAbove);
    plan.upright = planLayers(scene, settings, eye, {eye.clipFromCentred, glm::dvec3(camera.target()), pixelsPerMm},
                              subject, shadows);
    plan.flipped = scene.hasFlipped ? flippedPlan(scene, faces, plan.upright, eye, shadows) : LayerPlan{};
    plan.faces = seenOfAny(plan);

    shader::FrameData& data = plan.data;
    data.clipFromBoard = glm::mat4(eye.clipFromCentred);
    setPlanes(eye.clipFromCentred, data);
    setScreen(eye.clipFromCentred, static_cast<double>(width), static_cast<double>(height), data);
    data.centre = camera.target();
    data.width = width;
    data.height = height;
    data.eye = eye.isParallel ? glm::vec4(-eye.direction, 0.0F) : glm::vec4(eye.position - camera.target(), 1.0F);
    data.pixelsPerMm = pixelsPerMm;
    data.tolerancePx = toleranceOf(settings);
    const bool seesOneFace = plan.faces.upper != plan.faces.lower;
    const bool canFlatten = seesOneFace && !settings.isMono;
    data.quadRadiusPx = canFlatten ? kQuadRadiusPx : 0.0F;
    data.thinPx = canFlatten ? kThinPx : 0.0F;
    data.nudgeZ = eye.isParallel ? 0.0F : kNudgePerspective;
    data.nudgeW = eye.isParallel ? kNudgeParallel : 0.0F;
    const float depthPerMm =
        eye.isParallel ? std::abs(camera.projection(1.0F)[2][2]) / kNudgeParallel : 1.0F / kNudgePerspective;
    data.sliverNudge = kPositionRoundingPx * depthPerMm / data.pixelsPerMm;
    data.boreProtrusionMm = std::max(kBoreProtrusionMm, kBoreProtrusionSteps * eye.stepMm);
    data.light = kLight;
    data.keyLight = keyLightOf(eye, data);
    plan.hasSection = settings.section != nullptr && !settings.is2d;
    data.sectionPlane = plan.hasSection ? sectionOf(settings.section->plane, data.centre) : glm::vec3(0.0F);
    data.restStrength = restStrengthOf(settings);
    data.shadows.strength = shadows.strength();
    data.background = backgroundOf(settings);
    data.flags = flagsOf(settings) | (settings.isOutlined && isFlatView(plan) ? shader::kFrameOutlines : 0) |
                 (subject == Subject::StandingOut ? shader::kFrameStandingOut : 0);
    setTriangleRun(plan.faces, data);
    return plan;
}

}  // namespace render
