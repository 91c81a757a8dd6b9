#include "tri/gpu/triangulator.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <cstring>

#include "render/gpu/barrier.h"
#include "render/gpu/instance.h"
#include "shaders/tri/predicates.h"
#include "tests/unit/tri/cases.h"
#include "tests/unit/tri/generator.h"
#include "tests/unit/tri/gpu/oracle.h"
#include "tests/unit/tri/predicate_vectors.h"
#include "tri/gpu/device_forest.h"
#include "tri/verify.h"

using cases::Case;
using cases::Generator;
using tri::gpu::Eraser;

namespace {

namespace kernel = shader::tri;

kernel::ivec2 toVector(base::Point p) {
    return {p.x, p.y};
}

/// SPIR-V of a shader that belongs to this test alone; nothing if it does not compile.
std::vector<std::uint32_t> compile(const QString& source) {
    const QTemporaryDir folder;
    const QString name = folder.filePath("shader.spv");
    QFile file(name);
    if (QProcess::execute(COPPERSCOPE_GLSLANG,
                          {"--quiet", "-S", "comp", "--target-env", "vulkan1.3", "-o", name, source}) != 0 ||
        !file.open(QIODevice::ReadOnly)) {
        return {};
    }
    const QByteArray bytes = file.readAll();
    std::vector<std::uint32_t> code(static_cast<std::size_t>(bytes.size()) / sizeof(std::uint32_t));
    std::memcpy(code.data(), bytes.constData(), code.size() * sizeof(code[0]));
    return code;
}

std::vector<tri::Polygon> polygonsOf(const std::vector<Case>& inputs) {
    std::vector<tri::Polygon> polygons;
    std::ranges::transform(inputs, std::back_inserter(polygons), &Case::polygon);
    return polygons;
}

}  // namespace

/// The kernels on a device against the sequential triangulator and, step by step, against their oracle.
class TriangulatorTest : public QObject {
    Q_OBJECT

    std::optional<render::gpu::Instance> m_instance;
    std::optional<render::gpu::Device> m_device;

    /// All of them, through a device: the same as on the CPU, edges of crossings included.
    void compare(const std::vector<Case>& inputs, Eraser eraser = Eraser::Sector) {
        tri::gpu::Triangulator triangulator(*m_device);
        base::Progress progress;
        const auto results = triangulator.triangulate(polygonsOf(inputs), progress, eraser);
        m_tally = triangulator.tally();
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            std::vector<std::uint32_t> expected;
            const tri::Status status = tri::triangulate(inputs[i].polygon(), tri::Triangulator::Cpu, expected);
            QVERIFY2(results[i].status == status, inputs[i].name.c_str());
            QVERIFY2(tri::triangleSetHash(results[i].triangles) == tri::triangleSetHash(expected),
                     inputs[i].name.c_str());
        }
    }
    tri::gpu::Tally m_tally;

    /// The mesh in the device's memory and in the oracle's: the same words wherever there is a triangle.
    static bool isSameMesh(const tri::gpu::DeviceForest& forest, const tri::gpu::Oracle& oracle) {
        const std::size_t count = 2 * std::size_t{oracle.forest().vertexCount};
        const auto found = forest.read<kernel::Triangle>(offsetof(kernel::Forest, triangles), count);
        for (std::size_t t = 0; t < count; ++t) {
            const std::vector<std::uint32_t> expected = tri::gpu::Oracle::meshAt(oracle.forest().triangles.at[t]);
            if (!expected.empty() && tri::gpu::Oracle::meshAt(found[t]) != expected) {
                return false;
            }
        }
        return true;
    }

private slots:
    void initTestCase() {
        auto instance = render::gpu::Instance::create({});
        QVERIFY(instance.ok());
        m_instance.emplace(std::move(*instance));
        auto device = render::gpu::Device::create(*m_instance);
        QVERIFY(device.ok());
        m_device.emplace(std::move(*device));
    }
    void cleanupTestCase() {
        m_device.reset();
        m_instance.reset();
    }

    void predicatesGiveTheSameNumbersAsInCpp() {
        struct Answer {
            kernel::uvec2 orient;
            kernel::uvec4 inCircle;
            std::uint32_t isInside;
            std::uint32_t rank;
        };
        const std::vector<cases::Question> questions = cases::predicateQuestions();
        static const std::vector<std::uint32_t> code = compile(COPPERSCOPE_PREDICATES_SHADER);  // the device keeps it
        QVERIFY(!code.empty());
        struct Push {
            VkDeviceAddress questions, answers;
            std::uint32_t count, reserved;
        };
        const render::gpu::Pipeline pipeline(*m_device,
                                             render::gpu::ComputePipelineOptions{"test", code, sizeof(Push)});
        const auto use = render::gpu::MemoryUse::Transient;
        const render::gpu::Buffer in(
            *m_device, {"questions", sizeof(questions[0]) * questions.size(), use, render::gpu::HostAccess::Writes});
        const render::gpu::Buffer out(
            *m_device, {"answers", sizeof(Answer) * questions.size(), use, render::gpu::HostAccess::Reads});
        std::memcpy(in.mapped().data(), questions.data(), in.mapped().size());
        render::gpu::FrameRing ring(*m_device, 1, "test");
        const VkCommandBuffer commands = ring.begin()->commands();
        const auto count = static_cast<std::uint32_t>(questions.size());
        pipeline.bind(commands);
        pipeline.push(commands, Push{in.address(), out.address(), count, 0});
        vkCmdDispatch(commands, (count + 63) / 64, 1, 1);
        render::gpu::memoryBarrier(commands, render::gpu::kCompute, render::gpu::kHostRead);
        QVERIFY(ring.end() && ring.wait());
        for (std::size_t i = 0; i < questions.size(); ++i) {
            Answer answer{};
            std::memcpy(&answer, out.mapped().data() + i * sizeof(answer), sizeof(answer));
            const cases::Question& q = questions[i];
            const std::array at{toVector(q.points[0]), toVector(q.points[1]), toVector(q.points[2]),
                                toVector(q.points[3])};
            const kernel::uvec4 ids{q.ids[0], q.ids[1], q.ids[2], q.ids[3]};
            const kernel::uvec4 expected = kernel::inCircle(at[0], at[1], at[2], at[3]);
            QVERIFY(answer.orient == kernel::orient(at[0], at[1], at[2]));
            QVERIFY(answer.inCircle == expected);
            QCOMPARE(answer.isInside != 0, kernel::isInPerturbedCircle(at[0], at[1], at[2], at[3], ids));
            QCOMPARE(answer.rank, kernel::isNegative128(expected) ? 0 : kernel::rankOf(expected));
        }
    }

    void everyStepIsTheOracles() {
        // Steps only, small trees as well: the forest's kernels one by one.
        std::vector<Case> inputs = cases::nasty();
        inputs.push_back(cases::plane(5));
        inputs.push_back(cases::channels(12));
        const tri::gpu::ForestData data = tri::gpu::plant(polygonsOf(inputs), Eraser::Sector);
        tri::gpu::Oracle oracle(data, tri::gpu::CallOrder::Forward);
        render::gpu::FrameRing ring(*m_device, 2, "test");
        const tri::gpu::Kernels kernels(*m_device);
        const tri::gpu::DeviceForest forest(*m_device, ring, data);
        int steps = 0;
        for (bool isMore = true; isMore; ++steps) {
            render::gpu::Frame* frame = ring.begin();
            if (steps == 0) {
                forest.recordInit(*frame, kernels);
            }
            forest.recordStep(*frame, kernels);
            QVERIFY(ring.end());
            isMore = oracle.step();
            QVERIFY2(isSameMesh(forest, oracle), qPrintable(QString::number(steps)));
            QCOMPARE(forest.control().phase, oracle.control().phase);
            QCOMPARE(forest.control().flips, oracle.control().flips);
        }
        QVERIFY(steps > 20);
    }

    void namedCasesComeOutAsFromTheCpu() {
        compare(cases::nasty());
        QVERIFY(m_tally.onDevice >= 19);
    }

    void randomPolygonsComeOutAsFromTheCpu() {
        std::vector<Case> inputs;
        for (unsigned seed = 0; seed < 100; ++seed) {
            Generator generator(seed);
            inputs.push_back(generator.cells(2 + generator.below(7)));
            inputs.push_back(generator.scribble(2 + generator.below(4), 8));
            inputs.push_back(generator.star(10 << generator.below(20), 3 + generator.below(200)));
        }
        compare(inputs);
        QVERIFY(m_tally.onDevice > 100);
    }

    void planesAndChannelsNeedNoHelp() {
        const std::vector<Case> inputs = {cases::plane(12), cases::plane(3), cases::channels(3), cases::channels(25)};
        for (const Eraser eraser : {Eraser::Sector, Eraser::Loop}) {
            compare(inputs, eraser);
            QCOMPARE(m_tally.onDevice, inputs.size());
        }
    }

    void thePapersRuleIsPutRightByTheCpu() {
        compare({Case{"island"}
                     .loop(cases::square(0, 0, 100))
                     .loop(cases::squareHole(20, 20, 60))
                     .loop(cases::square(40, 40, 20))},
                Eraser::Loop);
        QCOMPARE(m_tally.flagged, std::size_t{1});
    }

    void smallPolygonsNeedNoSteps() {
        // One workgroup each, which has nothing left for the kernels that go through the whole forest.
        const std::vector<Case> inputs = {cases::lattice(7), cases::channels(12), cases::plane(3)};
        compare(inputs);
        QCOMPARE(m_tally.onDevice, inputs.size());
        QCOMPARE(m_tally.rounds, 0U);
        QVERIFY(m_tally.flips > 100);
    }

    void cancellingStopsAtOnce() {
        tri::gpu::Triangulator triangulator(*m_device);
        base::Progress progress;
        progress.cancel();
        const Case input = cases::plane(12);
        const std::vector<tri::Polygon> polygons{input.polygon()};
        QVERIFY(triangulator.triangulate(polygons, progress).front().triangles.empty());
        QCOMPARE(triangulator.tally().steps, 0U);
    }

    void nothingInNothingOut() {
        compare({});
        compare({Case{"nothing"}});
        QCOMPARE(m_tally.onDevice, std::size_t{0});
    }
};

QTEST_APPLESS_MAIN(TriangulatorTest)
#include "triangulator_test.moc"
