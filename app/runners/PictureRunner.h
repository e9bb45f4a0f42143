// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/WorkProgress.h"
#include "model/io/project/Project.h"
#include "views/render/OffscreenRenderer.h"

#include <QObject>

#include <functional>
#include <memory>

namespace espalier {

/// Draws a picture of a tree for a file or for the clipboard, from a snapshot: a worker thread makes the
/// mesh, then the passes are drawn one by one between the events of the window. So the document goes on
/// meanwhile.
class PictureRunner : public QObject {
    Q_OBJECT

public:
    using Done = std::function<void(const Result<QImage>&)>;

    explicit PictureRunner(QObject* parent = nullptr);
    ~PictureRunner() override;

    /// Draws the tree of @p project at the moment shown, in place of a picture that is under way. @p done is
    /// called with the picture, unless it is cancelled.
    void start(Project project, const PictureRequest& request, Done done);
    void cancel();
    bool isRunning() const { return m_job != nullptr; }

Q_SIGNALS:
    /// The finished share, 0...1.
    void progressed(double share);
    /// The picture is done, or was cancelled.
    void ended();

private:
    struct Job;

    void beginDrawing(const std::shared_ptr<Job>& job);
    void draw(const std::shared_ptr<Job>& job);
    void end(const std::shared_ptr<Job>& job, const Result<QImage>& picture);

    std::shared_ptr<Job> m_job;
};

} // namespace espalier
