// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/AnotherController.h"

#include "app/runners/Background.h"
#include "commands/AnotherTree.h"
#include "commands/DocumentProject.h"
#include "commands/recipe/JournalRecipe.h"
#include "model/base/Parallel.h"
#include "panels/Notice.h"
#include "views/Viewport.h"
#include "views/render/OffscreenRenderer.h"

#include <optional>
#include <utility>

namespace espalier {

namespace {

/// Passes of a picture; see RenderOptions::samples.
constexpr int kPictureSamples = 4;

} // namespace

/// What the worker thread needs. It handles one tree at a time.
struct AnotherController::Job {
    Project project{};
    int picture = 0; ///< Edge, px
    std::optional<Result<Recipe>> recipe{};
    std::atomic<bool> isCancelled = false;
};

/// A tree that the worker thread has made.
struct AnotherController::Grown {
    QString error{};                         ///< Why there is none; empty if there is one
    std::unique_ptr<PreparedTree> tree{};    ///< With its history; null if the work was cancelled
    std::unique_ptr<PreparedTree> picture{}; ///< The same tree, for its picture
    std::unique_ptr<PreparedScene> scene{};
};

AnotherController::AnotherController(Parts parts) : m_parts(std::move(parts))
{
    connect(&m_parts.panel, &AnotherPanel::chosen, this, &AnotherController::take);
    connect(&m_parts.panel, &AnotherPanel::closeAsked, this, &AnotherController::close);
    connect(&m_parts.panel, &AnotherPanel::moreAsked, this, [this] {
        m_first += AnotherPanel::kCount;
        begin();
    });
    // They are like a tree that is not there any more.
    connect(&m_parts.document, &TreeDocument::changed, this, [this] { close(); });
}

AnotherController::~AnotherController()
{
    if (m_job)
        m_job->isCancelled = true;
}

void AnotherController::toggle()
{
    if (close() || m_parts.isBusy())
        return;
    if (m_parts.document.journal().empty()) {
        m_parts.notice.showInformation(tr("Draw a tree first: then there can be others like it."));
        return;
    }
    m_first = 0;
    begin();
    m_parts.show(true);
    m_parts.panel.takeFocus();
}

bool AnotherController::close()
{
    if (!m_job)
        return false;
    std::exchange(m_job, nullptr)->isCancelled = true;
    m_trees = {};
    m_renderer.reset();
    m_parts.show(false);
    return true;
}

void AnotherController::begin()
{
    if (m_job)
        m_job->isCancelled = true;
    m_parts.document.interruptEdit();
    m_trees = {};
    m_grown = 0;
    m_parts.panel.clear();
    m_job = std::make_shared<Job>();
    m_job->project = projectOf(m_parts.document, {});
    m_job->picture = AnotherPanel::pictureIn(m_parts.viewport.size());
    growNext();
}

void AnotherController::growNext()
{
    const std::uint64_t seed = seedOfAnother(m_parts.document.tree().seed(), m_first + m_grown);
    runInBackground(
        this,
        [job = m_job, seed] {
            return std::make_shared<Grown>(leavingOneThread([&] {
                if (!job->recipe)
                    job->recipe = recipeOf(job->project);
                if (!*job->recipe)
                    return Grown{.error = job->recipe->error().message};
                Grown grown{.tree = anotherTree(**job->recipe, seed, job->isCancelled)};
                if (!grown.tree || job->isCancelled)
                    return Grown{};
                grown.picture = std::make_unique<PreparedTree>(grown.tree->tree, Journal());
                grown.scene = std::make_unique<PreparedScene>(grown.tree->tree, grown.tree->index,
                                                              grown.tree->growthModel->space());
                return grown;
            }));
        },
        [this, asked = std::weak_ptr(m_job)](const std::shared_ptr<Grown>& grown) {
            if (m_job && asked.lock() == m_job)
                receive(std::move(*grown));
        });
}

void AnotherController::receive(Grown grown)
{
    if (!grown.error.isEmpty()) {
        close();
        m_parts.notice.showWarning(grown.error);
        return;
    }
    const int number = m_grown++;
    m_parts.panel.setPicture(number, pictureOf(grown));
    m_trees[static_cast<std::size_t>(number)] = std::move(grown.tree);
    if (m_grown < AnotherPanel::kCount)
        growNext();
}

/// The tree as the viewport would show it.
QImage AnotherController::pictureOf(Grown& grown)
{
    if (!m_renderer) {
        Result<std::unique_ptr<OffscreenRenderer>> made = OffscreenRenderer::create();
        if (!made)
            return {};
        m_renderer = std::move(*made);
    }
    TreeDocument document;
    TreeScene scene(document);
    scene.expect(std::move(*grown.scene));
    document.reset(std::move(*grown.picture));
    scene.follow({TreeChange::Kind::Reset, nullptr});
    Camera camera = m_parts.viewport.mainCamera();
    const auto edge = static_cast<double>(m_job->picture) * m_parts.panel.devicePixelRatioF();
    camera.setViewSize({edge, edge});
    RenderOptions options;
    options.view = m_parts.settings.values();
    options.view.tracing = {};
    options.samples = kPictureSamples;
    const Result<QImage> picture = m_renderer->render(scene, camera.framing(scene.outline()), options);
    return picture ? *picture : QImage();
}

void AnotherController::take(int number)
{
    std::unique_ptr<PreparedTree> tree = std::move(m_trees[static_cast<std::size_t>(number)]);
    if (!tree || m_parts.isBusy())
        return;
    close();
    m_parts.viewport.setFocus();
    m_parts.document.exchange(std::move(*tree), tr("Another Like This"));
}

} // namespace espalier
