// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the cost of a frame relative to a bare draw of the same triangles, which uses only their
// positions: both are measured in turn, in one run. "espalier_render_bench [PROJECT]"; without a project, a
// tree of 50,000 internodes with leaves.
#include "commands/DocumentProject.h"
#include "commands/GrowGesture.h"
#include "model/io/project/ProjectFile.h"
#include "model/mesh/LeafCard.h"
#include "views/render/FramePacer.h"
#include "views/render/OffscreenRenderer.h"
#include "views/render/RenderTarget.h"
#include "views/render/Renderer.h"

#include <QElapsedTimer>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLShaderProgram>

#include <algorithm>
#include <cstdio>
#include <ctime>

namespace espalier {

namespace {

constexpr QSize kSize(1280, 800); ///< The window's first size
constexpr std::uint32_t kInternodes = 50'000;
constexpr int kRounds = 5;
constexpr int kFramesUntilPaced = 16; ///< Frames after which the pacer has found this machine's speed

/// Draws the triangles without light.
class BareDraw {
public:
    BareDraw(Gl& gl, const MeshPool& mesh) : m_gl(gl), m_array(gl), m_positions(gl), m_indices(gl)
    {
        std::vector<std::array<float, 3>> positions;
        for (const MeshVertex& vertex : mesh.vertices())
            positions.push_back(vertex.position);
        std::vector<VertexIndex> indices(mesh.indices().begin(), mesh.indices().end());
        const TriangleMesh leaves = expandLeaves(mesh.leaves());
        const auto first = static_cast<VertexIndex>(positions.size());
        for (const MeshVertex& vertex : leaves.vertices)
            positions.push_back(vertex.position);
        for (const VertexIndex index : leaves.indices)
            indices.push_back(first + index);
        m_count = static_cast<GLsizei>(indices.size());

        const std::size_t bytes = positions.size() * sizeof(positions[0]);
        m_positions.reserve(bytes);
        m_positions.write(0, positions.data(), bytes);
        m_indices.reserve(indices.size() * sizeof(indices[0]));
        m_indices.write(0, indices.data(), indices.size() * sizeof(indices[0]));
        gl.glBindVertexArray(m_array.get());
        gl.glBindBuffer(GL_ARRAY_BUFFER, m_positions.name());
        gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_indices.name());
        gl.glEnableVertexAttribArray(0);
        gl.glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
        gl.glBindVertexArray(0);
        m_program.addShaderFromSourceCode(
            QOpenGLShader::Vertex, "#version 330 core\n"
                                   "layout(location = 0) in vec3 position;\n"
                                   "uniform mat4 clipFromWorld;\n"
                                   "void main() { gl_Position = clipFromWorld * vec4(position, 1.0); }\n");
        m_program.addShaderFromSourceCode(QOpenGLShader::Fragment, "#version 330 core\n"
                                                                   "out vec4 colour;\n"
                                                                   "void main() { colour = vec4(1.0); }\n");
        if (!m_program.link())
            qFatal("%s", qPrintable(m_program.log()));
    }

    int triangles() const { return m_count / 3; }

    void draw(const Camera& camera, RenderTarget& target)
    {
        target.begin(camera.viewSize().toSize());
        m_gl.glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
        m_gl.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        m_gl.glEnable(GL_DEPTH_TEST);
        m_gl.glDepthMask(GL_TRUE);
        m_gl.glDisable(GL_CULL_FACE);
        m_gl.glDisable(GL_BLEND);
        m_program.bind();
        setMatrix(m_program, "clipFromWorld", camera.projectionMatrix(0.5F, 100.0F) * camera.viewMatrix());
        m_gl.glBindVertexArray(m_array.get());
        m_gl.glDrawElements(GL_TRIANGLES, m_count, GL_UNSIGNED_INT, nullptr);
    }

private:
    Gl& m_gl;
    GlVertexArray m_array;
    GlBuffer m_positions;
    GlBuffer m_indices;
    QOpenGLShaderProgram m_program;
    GLsizei m_count = 0;
};

struct Cost {
    double wall = 0.0; ///< s
    double cpu = 0.0;  ///< s, of all threads
};

double cpuTime()
{
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Draw>
Cost costOf(Gl& gl, Draw&& draw)
{
    gl.glFinish();
    QElapsedTimer timer;
    timer.start();
    const double before = cpuTime();
    draw();
    gl.glFinish();
    return {static_cast<double>(timer.nsecsElapsed()) * 1e-9, cpuTime() - before};
}

double median(const std::vector<Cost>& costs, double Cost::*which)
{
    std::vector<double> numbers;
    for (const Cost& cost : costs)
        numbers.push_back(cost.*which);
    std::ranges::sort(numbers);
    return numbers[numbers.size() / 2];
}

void report(const char* name, const std::vector<Cost>& costs, const std::vector<Cost>& bare)
{
    std::printf("%-42s %8.1f ms %6.2f  %8.1f ms %6.2f\n", name, 1e3 * median(costs, &Cost::wall),
                median(costs, &Cost::wall) / median(bare, &Cost::wall), 1e3 * median(costs, &Cost::cpu),
                median(costs, &Cost::cpu) / median(bare, &Cost::cpu));
}

void fill(TreeDocument& document, const QStringList& arguments)
{
    if (arguments.size() > 1) {
        Result<Project> project = loadProject(arguments[1]);
        if (!project)
            qFatal("%s", qPrintable(project.error().message));
        showProject(document, std::move(*project));
        return;
    }
    GrowGesture growth(document);
    while (document.index().livingCount() < kInternodes && growth.step()) {
    }
    growth.finish();
}

int run(const QStringList& arguments)
{
    TreeDocument document;
    fill(document, arguments);
    TreeScene scene(document);
    scene.prepare();
    QOpenGLContext context;
    context.setFormat(surfaceFormat());
    QOffscreenSurface surface;
    if (!context.create())
        qFatal("There is no OpenGL");
    surface.setFormat(context.format());
    surface.create();
    if (!context.makeCurrent(&surface))
        qFatal("There is no OpenGL");
    Gl& gl = *currentGl();
    {
        Renderer renderer(gl);
        RenderTarget plain(gl);
        RenderTarget picture(gl);
        RenderTarget moving(gl);
        BareDraw bare(gl, scene.mesh());
        std::printf("%s, %u internodes, %zu leaves, %d triangles, %d × %d pixels\n",
                    gl.glGetString(GL_RENDERER), document.index().livingCount(), scene.mesh().leaves().size(),
                    bare.triangles(), kSize.width(), kSize.height());

        Camera camera = pictureCamera(NamedView::ThreeQuarter, scene, kSize);
        const RenderOptions best;
        FramePacer pacer;
        pacer.disturb();
        const auto drawMoving = [&] {
            RenderOptions options;
            pacer.apply(options);
            Camera scaled = camera;
            scaled.setViewSize((QSizeF(kSize) * pacer.scale()).toSize());
            renderer.render(scene, scaled, options, moving);
        };
        for (int i = 0; i < kFramesUntilPaced; ++i)
            pacer.frameTook(costOf(gl, drawMoving).wall);
        const auto drawFull = [&](const RenderOptions& options) {
            renderer.renderPass(scene, camera, options, picture, 1);
        };
        renderer.renderPass(scene, camera, best, picture, 0);

        std::vector<Cost> bareCosts;
        std::vector<Cost> full;
        std::vector<Cost> withShadows;
        std::vector<Cost> hand;
        for (int round = 0; round < kRounds; ++round) {
            camera.orbit(0.01F, 0.0F);
            bareCosts.push_back(costOf(gl, [&] { bare.draw(camera, plain); }));
            full.push_back(costOf(gl, [&] { drawFull(best); }));
            hand.push_back(costOf(gl, drawMoving));
            RenderOptions turned = best;
            turned.view.sunAzimuth += 0.01 * (round + 1);
            withShadows.push_back(costOf(gl, [&] { drawFull(turned); }));
            drawFull(best);
        }
        std::printf("%-42s %11s %6s  %11s %6s\n", "", "time", "ratio", "CPU", "ratio");
        report("bare", bareCosts, bareCosts);
        report("full quality (each of a picture's passes)", full, bareCosts);
        report("full quality, its shadows made anew", withShadows, bareCosts);
        report("a hand moves", hand, bareCosts);
    }
    context.doneCurrent();
    return 0;
}

} // namespace

} // namespace espalier

int main(int argc, char* argv[])
{
    const QGuiApplication application(argc, argv);
    return espalier::run(QGuiApplication::arguments());
}
