// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/PictureRunner.h"

#include "app/runners/Background.h"
#include "commands/DocumentProject.h"
#include "model/mesh/ShownStrands.h"
#include "views/render/PreparedScene.h"

#include <QTimer>

namespace espalier {

/// A picture that is under way.
struct PictureRunner::Job {
    PictureRequest request{};
    Done done{};
    std::shared_ptr<WorkProgress> progress = std::make_shared<WorkProgress>();
    TreeDocument document{};
    std::unique_ptr<TreeScene> scene{};
    std::unique_ptr<OffscreenRenderer> renderer{};
    Camera camera{};
    int pass = 0; ///< The next one
};

namespace {

/// Share of the progress that the mesh takes.
constexpr double kMeshShare = 0.3;

/// What a worker thread makes for a picture.
struct PictureParts {
    PreparedTree tree;
    PreparedScene scene;
    std::shared_ptr<const ShownStrands> strands; ///< Null if the wood is tubes, or if the work was cancelled
};

PictureParts partsFor(Project project, bool withFibres, WorkProgress& progress)
{
    PreparedTree tree = prepared(std::move(project));
    PreparedScene scene(tree.tree, tree.index, tree.growthModel->space());
    std::shared_ptr<const ShownStrands> strands;
    if (withFibres || tree.tree.parameters().wood.mesher == WoodMesherKind::Strands)
        strands = makeShownStrands(tree.tree, withFibres, nullptr, progress);
    return {std::move(tree), std::move(scene), std::move(strands)};
}

} // namespace

PictureRunner::PictureRunner(QObject* parent) : QObject(parent) {}

PictureRunner::~PictureRunner()
{
    if (m_job)
        m_job->progress->cancel();
}

void PictureRunner::start(Project project, const PictureRequest& request, Done done)
{
    cancel();
    const auto job = std::make_shared<Job>();
    job->request = request;
    job->done = std::move(done);
    m_job = job;
    Q_EMIT progressed(0.0);
    runInBackground(
        this,
        [project = std::move(project), fibres = request.options.view.fibresShown,
         progress = job->progress]() mutable -> Result<PictureParts> {
            return partsFor(std::move(project), fibres, *progress);
        },
        [this, job](Result<PictureParts> made) {
            if (m_job != job)
                return;
            if (!made) {
                end(job, made.error());
                return;
            }
            PictureParts parts = std::move(*made);
            job->scene = std::make_unique<TreeScene>(job->document);
            job->scene->setFibresShown(job->request.options.view.fibresShown);
            job->scene->expect(std::move(parts.scene));
            job->document.reset(std::move(parts.tree));
            job->scene->follow({TreeChange::Kind::Reset, nullptr});
            if (parts.strands)
                job->scene->setStrands(std::move(parts.strands), job->document.revision());
            beginDrawing(job);
        });
}

/// Begins to draw, when the window has had its turn.
void PictureRunner::beginDrawing(const std::shared_ptr<Job>& job)
{
    auto renderer = OffscreenRenderer::create();
    if (!renderer) {
        end(job, renderer.error());
        return;
    }
    job->renderer = std::move(*renderer);
    job->camera = cameraFor(job->request, *job->scene);
    QTimer::singleShot(0, this, [this, job] { draw(job); });
}

void PictureRunner::draw(const std::shared_ptr<Job>& job)
{
    if (m_job != job)
        return;
    const RenderOptions& options = job->request.options;
    const Result<void> drawn = job->renderer->renderPass(*job->scene, job->camera, options, job->pass);
    if (!drawn) {
        end(job, drawn.error());
        return;
    }
    ++job->pass;
    Q_EMIT progressed(kMeshShare + (1.0 - kMeshShare) * job->pass / options.samples);
    if (m_job != job)
        return;
    if (job->pass >= options.samples)
        end(job, job->renderer->picture());
    else
        QTimer::singleShot(0, this, [this, job] { draw(job); });
}

void PictureRunner::end(const std::shared_ptr<Job>& job, const Result<QImage>& picture)
{
    m_job.reset();
    Q_EMIT ended();
    job->done(picture);
}

void PictureRunner::cancel()
{
    const std::shared_ptr<Job> job = std::exchange(m_job, nullptr);
    if (!job)
        return;
    job->progress->cancel();
    Q_EMIT ended();
}

} // namespace espalier
