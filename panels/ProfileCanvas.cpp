// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ProfileCanvas.h"

#include "model/strands/ProfileMorph.h"
#include "panels/Theme.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QTabletEvent>
#include <QTouchEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

/// Part of the widget's side that a whole section takes.
constexpr double kShownShare = 0.86;
/// A hand-drawn outline is at least so wide, px; an attractor is at least so long.
constexpr double kLeastSketch = 12.0;
constexpr double kLeastAttractor = 6.0;
/// Of strands from an earlier state of the tree.
constexpr double kOldOpacity = 0.45;
constexpr double kLeastZoom = 4.0;
constexpr double kGreatestZoom = 4000.0;

/// Of the strands of a branch: the axis has the colour of wood, the others are spread over the circle of
/// hues.
QColor colourOfBranch(std::uint8_t branch)
{
    if (branch == 0)
        return theme::isLight() ? QColor(176, 146, 108) : QColor(168, 140, 104);
    const double hue = std::fmod(0.27 + 0.381966 * branch, 1.0);
    return QColor::fromHsvF(static_cast<float>(hue), 0.42F, theme::isLight() ? 0.74F : 0.78F);
}

double distanceToLine(const QPointF& place, const QPointF& from, const QPointF& to)
{
    const QPointF edge = to - from;
    const double length = QPointF::dotProduct(edge, edge);
    const double t =
        length > 0.0 ? std::clamp(QPointF::dotProduct(place - from, edge) / length, 0.0, 1.0) : 0.0;
    const QPointF offset = place - from - t * edge;
    return std::hypot(offset.x(), offset.y());
}

} // namespace

ProfileCanvas::ProfileCanvas(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("profileCanvas"));
    setAccessibleName(tr("Cross-section"));
    setAttribute(Qt::WA_AcceptTouchEvents);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMode(Mode::Outline);
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

void ProfileCanvas::setMode(Mode mode)
{
    drop();
    m_mode = mode;
    setCursor(mode == Mode::Points ? Qt::OpenHandCursor : Qt::CrossCursor);
    update();
}

void ProfileCanvas::showSection(const ProfileSection& section, const StrandProfile& profile, bool isOther)
{
    const bool isFirst = !m_section || isOther;
    m_section = section;
    m_isOld = false;
    if (isFirst) {
        drop();
        setFault({});
    }
    const bool isChanged = isFirst || (m_profile != profile && !m_stroke);
    if (isChanged) {
        if (!m_faulty.empty())
            setFault({});
        m_profile = profile;
        m_axis = profile.boundaries.empty() ? std::vector<MedialSegment>() : medialAxis(profile);
    }
    if (isFirst || (isChanged && isCutOff()))
        fit();
    redraw();
}

bool ProfileCanvas::isCutOff() const
{
    const auto isOutside = [this](const Vec2& point) {
        return 2.0 * m_scale * double{std::abs(point.x())} > width() ||
               2.0 * m_scale * double{std::abs(point.y())} > height();
    };
    return std::ranges::any_of(m_profile.boundaries, [&](const StrandProfile::Loop& loop) {
        return std::ranges::any_of(loop, isOutside);
    });
}

void ProfileCanvas::clear()
{
    drop();
    m_section.reset();
    m_profile = {};
    m_axis.clear();
    setFault({});
    redraw();
}

void ProfileCanvas::setOld(bool old)
{
    if (m_isOld == old)
        return;
    m_isOld = old;
    redraw();
}

void ProfileCanvas::fit()
{
    Eigen::AlignedBox2f box(Vec2(-1.0F, -1.0F), Vec2(1.0F, 1.0F));
    for (const StrandProfile::Loop& loop : m_profile.boundaries) {
        for (const Vec2& point : loop)
            box.extend(point);
    }
    if (m_section) {
        for (const Vec2& place : m_section->places)
            box.extend(place);
    }
    const Vec2 size = box.sizes();
    m_scale = std::clamp(kShownShare * std::min(width() / double{size.x()}, height() / double{size.y()}),
                         kLeastZoom, kGreatestZoom);
    const Vec2 middle = box.center();
    m_middle = -m_scale * QPointF(double{middle.x()}, double{middle.y()});
    redraw();
}

QPointF ProfileCanvas::toWidget(const Vec2& point) const
{
    return QPointF(width() / 2.0, height() / 2.0) + m_middle +
           m_scale * QPointF(double{point.x()}, double{point.y()});
}

Vec2 ProfileCanvas::toProfile(const QPointF& place) const
{
    const QPointF point = (place - m_middle - QPointF(width() / 2.0, height() / 2.0)) / m_scale;
    return {static_cast<float>(point.x()), static_cast<float>(point.y())};
}

void ProfileCanvas::setFault(const QString& sentence, StrandProfile::Loop line)
{
    m_faulty = std::move(line);
    Q_EMIT faultChanged(sentence);
    update();
}

Vec2& ProfileCanvas::at(const Point& point)
{
    if (!point.isAttractor)
        return m_profile.boundaries[point.line][point.number];
    StrandProfile::Attractor& attractor = m_profile.attractors[point.line];
    return point.number == 0 ? attractor.from : attractor.to;
}

std::optional<ProfileCanvas::Point> ProfileCanvas::pointAt(const QPointF& place, double reach) const
{
    std::optional<Point> found;
    double nearest = reach;
    const auto consider = [&](const Vec2& point, const Point& which) {
        const QPointF offset = toWidget(point) - place;
        if (const double distance = std::hypot(offset.x(), offset.y()); distance < nearest) {
            nearest = distance;
            found = which;
        }
    };
    for (std::size_t line = 0; line < m_profile.boundaries.size(); ++line) {
        for (std::size_t i = 0; i < m_profile.boundaries[line].size(); ++i)
            consider(m_profile.boundaries[line][i], {false, line, i});
    }
    for (std::size_t line = 0; line < m_profile.attractors.size(); ++line) {
        consider(m_profile.attractors[line].from, {true, line, 0});
        consider(m_profile.attractors[line].to, {true, line, 1});
    }
    return found;
}

void ProfileCanvas::begin(const QPointF& place, Mode mode, double reach)
{
    if (!m_section || m_stroke)
        return;
    setFault({});
    m_stroke = mode;
    m_before = m_profile;
    m_reach = reach;
    m_drawn = {toProfile(place)};
    m_held = mode == Mode::Points ? pointAt(place, reach) : std::nullopt;
    if (m_held)
        setCursor(Qt::ClosedHandCursor);
    update();
}

void ProfileCanvas::move(const QPointF& place)
{
    m_hover = place;
    if (!m_stroke) {
        if (m_mode == Mode::Points)
            update();
        return;
    }
    m_drawn.push_back(toProfile(place));
    if (m_held)
        at(*m_held) = m_drawn.back().cwiseMax(-kFarthestProfilePoint).cwiseMin(kFarthestProfilePoint);
    update();
}

void ProfileCanvas::end()
{
    if (!m_stroke)
        return;
    const Mode mode = *m_stroke;
    m_stroke.reset();
    StrandProfile changed = m_profile;
    switch (mode) {
    case Mode::Outline: {
        const StrandProfile::Loop loop = sketchedLoop(m_drawn, static_cast<float>(kLeastSketch / m_scale));
        if (loop.empty())
            break;
        changed.boundaries.push_back(loop);
        offer(std::move(changed), loop);
        break;
    }
    case Mode::Attractor: {
        const Vec2 from = m_drawn.front();
        const Vec2 to = m_drawn.back();
        if (double{(to - from).norm()} * m_scale < kLeastAttractor)
            break;
        if (changed.boundaries.empty()) {
            setFault(tr("Draw an outline first: attractors gather the strands within it."));
            break;
        }
        changed.attractors.push_back({from, to});
        offer(std::move(changed), {});
        break;
    }
    case Mode::Points:
        setCursor(Qt::OpenHandCursor);
        if (m_held && changed != m_before) {
            const StrandProfile::Loop line =
                m_held->isAttractor ? StrandProfile::Loop() : changed.boundaries[m_held->line];
            m_profile = m_before;
            offer(std::move(changed), line);
        }
        break;
    case Mode::Erase:
        eraseAt(toWidget(m_drawn.back()), m_reach);
        break;
    }
    m_held.reset();
    m_drawn.clear();
    update();
}

void ProfileCanvas::drop()
{
    if (!m_stroke)
        return;
    m_stroke.reset();
    m_held.reset();
    m_drawn.clear();
    m_profile = m_before;
    update();
}

/// Makes @p profile the node's if it has no fault; otherwise @p drawn stays as a red line.
void ProfileCanvas::offer(StrandProfile profile, StrandProfile::Loop drawn)
{
    if (const QString fault = profileFault(profile); !fault.isEmpty()) {
        setFault(tr("This cannot be the profile: %1.").arg(fault), std::move(drawn));
        return;
    }
    m_profile = std::move(profile);
    m_axis = medialAxis(m_profile);
    setOld(true);
    Q_EMIT edited(m_profile);
}

void ProfileCanvas::eraseAt(const QPointF& place, double reach)
{
    double nearest = reach;
    std::optional<std::size_t> outline;
    std::optional<std::size_t> attractor;
    for (std::size_t line = 0; line < m_profile.boundaries.size(); ++line) {
        const StrandProfile::Loop& loop = m_profile.boundaries[line];
        for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
            const double distance = distanceToLine(place, toWidget(loop[j]), toWidget(loop[i]));
            if (distance < nearest) {
                nearest = distance;
                outline = line;
            }
        }
    }
    for (std::size_t line = 0; line < m_profile.attractors.size(); ++line) {
        const auto& [from, to] = m_profile.attractors[line];
        const double distance = distanceToLine(place, toWidget(from), toWidget(to));
        if (distance < nearest) {
            nearest = distance;
            attractor = line;
        }
    }
    StrandProfile changed = m_profile;
    if (attractor)
        changed.attractors.erase(changed.attractors.begin() + static_cast<std::ptrdiff_t>(*attractor));
    else if (outline)
        changed.boundaries.erase(changed.boundaries.begin() + static_cast<std::ptrdiff_t>(*outline));
    else
        return;
    if (changed.boundaries.empty()) {
        m_profile = {};
        m_axis.clear();
        setOld(true);
        Q_EMIT edited(m_profile);
        return;
    }
    offer(std::move(changed), {});
}

bool ProfileCanvas::cancelStroke()
{
    if (!m_stroke)
        return false;
    drop();
    return true;
}

bool ProfileCanvas::event(QEvent* event)
{
    // A press of the mouse sets the focus by itself.
    if (event->type() == QEvent::TouchBegin || event->type() == QEvent::TabletPress)
        setFocus(Qt::MouseFocusReason);
    switch (event->type()) {
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
        return touchEvent(static_cast<QTouchEvent*>(event));
    case QEvent::ShortcutOverride:
        // Escape belongs to a stroke under way.
        if (m_stroke && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
            event->accept();
            return true;
        }
        break;
    case QEvent::LanguageChange:
    case QEvent::PaletteChange:
        redraw();
        break;
    default:
        break;
    }
    return QWidget::event(event);
}

bool ProfileCanvas::touchEvent(QTouchEvent* event)
{
    event->accept();
    if (event->type() == QEvent::TouchCancel || event->points().size() > 1) {
        drop();
        return true;
    }
    const QPointF place = event->points().front().position();
    if (event->type() == QEvent::TouchBegin)
        begin(place, m_mode, kFingerReach);
    else
        move(place);
    if (event->type() == QEvent::TouchEnd)
        end();
    return true;
}

void ProfileCanvas::tabletEvent(QTabletEvent* event)
{
    event->accept();
    const bool isEraser = event->pointerType() == QPointingDevice::PointerType::Eraser;
    if (event->type() == QEvent::TabletPress)
        begin(event->position(), isEraser ? Mode::Erase : m_mode, kReach);
    else
        move(event->position());
    if (event->type() == QEvent::TabletRelease)
        end();
}

void ProfileCanvas::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        begin(event->position(), m_mode, kReach);
}

void ProfileCanvas::mouseMoveEvent(QMouseEvent* event)
{
    move(event->position());
}

void ProfileCanvas::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        end();
}

void ProfileCanvas::wheelEvent(QWheelEvent* event)
{
    event->accept();
    if (!m_section)
        return;
    const Vec2 under = toProfile(event->position());
    m_scale =
        std::clamp(m_scale * std::pow(1.15, event->angleDelta().y() / 120.0), kLeastZoom, kGreatestZoom);
    m_middle += event->position() - toWidget(under);
    redraw();
}

void ProfileCanvas::keyPressEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_Escape || !cancelStroke())
        QWidget::keyPressEvent(event);
}

void ProfileCanvas::resizeEvent(QResizeEvent*)
{
    fit();
}

void ProfileCanvas::leaveEvent(QEvent*)
{
    m_hover = QPointF(-1e6, -1e6);
    update();
}

void ProfileCanvas::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    QPainterPath clip;
    clip.addRoundedRect(frame, 6.0, 6.0);
    painter.fillPath(clip, theme::kSunken);
    painter.setClipPath(clip);
    if (!m_section) {
        painter.setPen(theme::kDimText);
        painter.drawText(frame.adjusted(24, 0, -24, 0), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Tap a branch of the tree to see its cross-section."));
    } else {
        // The axes of the section, and the round section that it would have.
        QColor faint = theme::kEdge;
        painter.setPen(QPen(faint, 1.0));
        const QPointF origin = toWidget(Vec2::Zero());
        painter.drawLine(QPointF(0.0, origin.y()), QPointF(width(), origin.y()));
        painter.drawLine(QPointF(origin.x(), 0.0), QPointF(origin.x(), height()));
        painter.setPen(QPen(theme::kFaintText, 1.0, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(origin, m_scale, m_scale);
        if (m_strands.isNull()) {
            m_strands = QPixmap(size() * devicePixelRatioF());
            m_strands.setDevicePixelRatio(devicePixelRatioF());
            m_strands.fill(Qt::transparent);
            QPainter strands(&m_strands);
            strands.setRenderHint(QPainter::Antialiasing);
            paintStrands(strands);
        }
        painter.setOpacity(m_isOld ? kOldOpacity : 1.0);
        painter.drawPixmap(0, 0, m_strands);
        painter.setOpacity(1.0);
        paintLines(painter);
    }
    painter.setClipping(false);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(hasFocus() ? theme::kAccent : theme::kEdge, 1.0));
    painter.drawRoundedRect(frame, 6.0, 6.0);
}

void ProfileCanvas::redraw()
{
    m_strands = {};
    update();
}

void ProfileCanvas::paintStrands(QPainter& painter) const
{
    const double radius = m_scale * double{m_section->strandRadius};
    // Strands smaller than a pixel merge into one surface.
    const bool isOutlined = radius > 2.2;
    const double drawn = isOutlined ? 0.94 * radius : std::max(radius, 0.7);
    for (std::size_t i = 0; i < m_section->places.size(); ++i) {
        const QPointF place = toWidget(m_section->places[i]);
        if (!rect().adjusted(-200, -200, 200, 200).contains(place.toPoint()))
            continue;
        const QColor colour = colourOfBranch(m_section->branch[i]);
        painter.setBrush(colour);
        painter.setPen(isOutlined ? QPen(colour.darker(150), std::min(1.2, 0.12 * radius)) : QPen(Qt::NoPen));
        painter.drawEllipse(place, drawn, drawn);
    }
}

void ProfileCanvas::paintLines(QPainter& painter) const
{
    QColor axisColour = theme::isLight() ? QColor(60, 66, 74) : QColor(24, 26, 30);
    axisColour.setAlpha(170);
    painter.setPen(QPen(axisColour, 1.4));
    for (const auto& [from, to] : m_axis)
        painter.drawLine(toWidget(from), toWidget(to));

    const auto closed = [&](const StrandProfile::Loop& loop) {
        QPolygonF polygon;
        for (const Vec2& point : loop)
            polygon.append(toWidget(point));
        return polygon;
    };
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme::kAccentText, 2.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    for (const StrandProfile::Loop& loop : m_profile.boundaries)
        painter.drawPolygon(closed(loop));
    painter.setPen(QPen(theme::kHandle, 3.2, Qt::SolidLine, Qt::RoundCap));
    for (const auto& [from, to] : m_profile.attractors)
        painter.drawLine(toWidget(from), toWidget(to));
    if (!m_faulty.empty()) {
        painter.setPen(QPen(theme::kWarning, 2.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolygon(closed(m_faulty));
    }

    if (m_mode == Mode::Points && !m_stroke.has_value()) {
        const std::optional<Point> hovered = pointAt(m_hover, kReach);
        painter.setPen(QPen(theme::kSunken, 1.0));
        for (std::size_t line = 0; line < m_profile.boundaries.size(); ++line) {
            for (std::size_t i = 0; i < m_profile.boundaries[line].size(); ++i) {
                const bool isLit =
                    hovered && !hovered->isAttractor && hovered->line == line && hovered->number == i;
                painter.setBrush(isLit ? theme::kHandle : theme::inForce.knob);
                painter.drawEllipse(toWidget(m_profile.boundaries[line][i]), isLit ? 5.5 : 3.6,
                                    isLit ? 5.5 : 3.6);
            }
        }
        painter.setBrush(theme::kHandle);
        for (const auto& [from, to] : m_profile.attractors) {
            painter.drawEllipse(toWidget(from), 5.0, 5.0);
            painter.drawEllipse(toWidget(to), 5.0, 5.0);
        }
    }
    if (m_stroke == Mode::Outline) {
        painter.setBrush(Qt::NoBrush);
        QPolygonF line;
        for (const Vec2& point : m_drawn)
            line.append(toWidget(point));
        painter.setPen(QPen(theme::kBrightText, 2.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(line);
        painter.setPen(QPen(theme::kDimText, 1.2, Qt::DotLine));
        painter.drawLine(line.front(), line.back());
    } else if (m_stroke == Mode::Attractor) {
        painter.setPen(QPen(theme::kHandle, 3.2, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(toWidget(m_drawn.front()), toWidget(m_drawn.back()));
    }
}

} // namespace espalier
