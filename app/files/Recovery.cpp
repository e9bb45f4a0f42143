// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/Recovery.h"

#include "app/runners/Background.h"
#include "model/io/project/ProjectFile.h"
#include "model/mesh/TreeCounts.h"
#include "panels/Notice.h"
#include "panels/RecoverySheet.h"

#include <QDir>
#include <QFileInfo>

#include <optional>

namespace espalier {

namespace {

constexpr int kPicturePasses = 4;

/// What became of an attempt to read a safety copy.
struct Tried {
    Leftover leftover;
    bool isUnreadable = false;
    bool isWorthless = false; ///< Nothing was done that could be brought back
};

std::vector<Tried> tryToRead(const std::vector<Leftover>& leftovers)
{
    std::vector<Tried> tried;
    for (const Leftover& leftover : leftovers) {
        const SafetyCopy copy = SafetyCopy::ofProject(leftover.fileName);
        const Result<Project> project = copy.read();
        const bool isSeedling = project && project->journal.empty() && project->tree.size() == 1 &&
                                leftover.original.isEmpty() && project->look == SceneLook();
        const bool isWorthless = project && (isSeedling || !copy.hasChanges());
        // What cannot be read may be worth something.
        const bool isLost = !project || (isWorthless && copy.isTorn());
        tried.push_back(
            {.leftover = leftover, .isUnreadable = isLost, .isWorthless = isWorthless && !isLost});
    }
    return tried;
}

/// Moves safety copies aside and returns a sentence about that; empty if there are none.
QString keptAside(const std::vector<Leftover>& leftovers)
{
    QStringList places;
    for (const Leftover& leftover : leftovers)
        places.append(QDir::toNativeSeparators(Autosave::keepAside(leftover)));
    if (places.isEmpty())
        return {};
    if (places.size() == 1)
        return Recovery::tr("The safety copy of %1 cannot be read. It is kept as %2.")
            .arg(leftovers.front().displayName(), places.front());
    return Recovery::tr("%n safety copies cannot be read. They are kept in %1.", nullptr,
                        static_cast<int>(places.size()))
        .arg(QFileInfo(places.front()).path());
}

RecoverableTree shownOf(const Leftover& leftover)
{
    RecoverableTree tree{
        .name = leftover.displayName(), .place = {}, .saved = {}, .changed = leftover.written};
    if (leftover.original.isEmpty())
        return tree;
    const QFileInfo file(leftover.original);
    tree.place = QDir::toNativeSeparators(file.absolutePath());
    if (file.isFile())
        tree.saved = file.lastModified();
    else
        tree.place = Recovery::tr("%1, but the file is no longer there").arg(tree.place);
    return tree;
}

} // namespace

/// What a worker thread finds out about a safety copy and the file that it comes from.
struct Recovery::Compared {
    struct Version {
        std::optional<Project> project{}; ///< None if it cannot be read
        QString caption{};
    };
    Version file;
    Version copy;
    Camera camera; ///< That shows both

    static Compared of(const Leftover& leftover, const QSize& size);
};

Recovery::Compared Recovery::Compared::of(const Leftover& leftover, const QSize& size)
{
    Box3 bounds;
    const auto version = [&bounds](Result<Project> read) {
        if (!read)
            return Version{{}, tr("It cannot be read.")};
        const TreeIndex index(read->tree);
        bounds.extend(treeBounds(read->tree, index));
        return Version{std::move(*read),
                       tr("%Ln internodes", nullptr, static_cast<int>(index.livingCount()))};
    };
    Compared compared;
    if (QFileInfo(leftover.original).isFile()) {
        compared.file = version(loadProject(leftover.original));
        if (leftover.content.exists() && FileContent::of(leftover.original) != leftover.content)
            compared.file.caption += QLatin1Char('\n') + tr("Changed by another program since");
    }
    compared.copy = version(SafetyCopy::ofProject(leftover.fileName).read());
    compared.camera.setViewSize(size);
    compared.camera = compared.camera.turnedTo(NamedView::Front).framing(bounds);
    return compared;
}

Recovery::Recovery(QWidget& window, Notice& notice, QObject* parent)
    : QObject(parent), m_window(window), m_notice(&notice)
{
}

void Recovery::start(Occasion occasion)
{
    m_occasion = occasion;
    if (m_isLooking || m_sheet)
        return;
    std::vector<Leftover> leftovers = Autosave::leftovers();
    if (leftovers.empty()) {
        offer(occasion);
        return;
    }
    m_isLooking = true;
    runInBackground(
        this,
        [leftovers = std::move(leftovers)]() -> Result<std::vector<Tried>> { return tryToRead(leftovers); },
        [this](const Result<std::vector<Tried>>& result) {
            m_isLooking = false;
            // Without memory to read them, they stay for later.
            const std::vector<Tried> tried = result ? *result : std::vector<Tried>();
            std::vector<Leftover> unreadable;
            for (const Tried& one : tried) {
                if (one.isWorthless)
                    Autosave::discard(one.leftover);
                else if (one.isUnreadable)
                    unreadable.push_back(one.leftover);
                else
                    m_offers.push_back(one.leftover);
            }
            m_toTell = keptAside(unreadable);
            offer(unreadable.empty() ? m_occasion : Occasion::Start);
            if (!m_sheet)
                tell();
        });
}

void Recovery::keepAside(const Leftover& leftover)
{
    m_toTell = keptAside({leftover});
    tell();
}

/// Shows the sentence that could not be seen beside the sheet.
void Recovery::tell()
{
    if (const QString sentence = std::exchange(m_toTell, {}); !sentence.isEmpty())
        m_notice->showWarning(sentence);
}

void Recovery::offer(Occasion occasion)
{
    if (m_offers.empty()) {
        if (occasion == Occasion::Asked)
            m_notice->showInformation(tr("There is nothing to bring back: all was saved, or given up."));
        return;
    }
    std::vector<RecoverableTree> trees;
    for (const Leftover& leftover : m_offers)
        trees.push_back(shownOf(leftover));
    m_sheet = new RecoverySheet(trees, &m_window);
    m_sheet->setAttribute(Qt::WA_DeleteOnClose);
    connect(m_sheet, &QDialog::finished, this, &Recovery::end);
    m_sheet->open();
    compare(0);
}

/// Shows what the sheet's tree with that index, and those after it, look like.
void Recovery::compare(std::size_t index)
{
    if (!m_sheet || index >= m_offers.size())
        return;
    const QSize pixels = m_sheet->pictureSize() * m_sheet->devicePixelRatioF();
    Leftover leftover = m_offers[index];
    leftover.lock.reset(); // It is free as soon as the sheet has closed
    runInBackground(
        this, [leftover, pixels]() -> Result<Compared> { return Compared::of(leftover, pixels); },
        [this, index, sheet = m_sheet](Result<Compared> compared) {
            if (!sheet || sheet != m_sheet)
                return;
            if (compared) {
                draw(index, std::make_shared<Compared>(std::move(*compared)));
                return;
            }
            for (const auto state : {RecoverySheet::State::Saved, RecoverySheet::State::Changed})
                sheet->showState(index, state, {}, QString());
            compare(index + 1);
        });
}

/// Draws the next picture of that tree.
void Recovery::draw(std::size_t index, std::shared_ptr<Compared> compared)
{
    using State = RecoverySheet::State;
    const bool isFile = !compared->file.caption.isEmpty();
    const State state = isFile ? State::Saved : State::Changed;
    const Compared::Version version = std::exchange(isFile ? compared->file : compared->copy, {});
    if (version.caption.isEmpty()) {
        compare(index + 1);
        return;
    }
    const auto show = [this, index, state, compared, caption = version.caption](const QImage& picture) {
        if (!m_sheet)
            return;
        m_sheet->showState(index, state, picture, caption);
        draw(index, compared);
    };
    if (!version.project) {
        show({});
        return;
    }
    PictureRequest request;
    request.camera = compared->camera;
    request.size = compared->camera.viewSize().toSize();
    request.options.samples = kPicturePasses;
    m_pictures.start(*version.project, request,
                     [show](const Result<QImage>& picture) { show(picture ? *picture : QImage()); });
}

/// The sheet has closed.
void Recovery::end()
{
    m_pictures.cancel();
    const std::vector<Leftover> offers = std::exchange(m_offers, {});
    const RecoverySheet& sheet = *std::exchange(m_sheet, nullptr);
    tell();
    for (const std::size_t index : sheet.discarded())
        Autosave::discard(offers[index]);
    if (const std::optional<std::size_t> chosen = sheet.broughtBack())
        Q_EMIT wanted(offers[*chosen]);
}

void Recovery::remind()
{
    const std::size_t count = Autosave::leftovers().size();
    if (count == 0)
        return;
    const QString text = count == 1
                             ? tr("Another tree can be brought back.")
                             : tr("%n other trees can be brought back.", nullptr, static_cast<int>(count));
    m_notice->showInformation(text, tr("Show"), [this] { start(Occasion::Asked); });
}

} // namespace espalier
