#include "studio/view3d/vtk_widget.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>
#include <QPaintEvent>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <algorithm>
#include <cmath>

namespace kumite::studio {

namespace {

/// Milliseconds without a change after which edges are smoothed.
constexpr int kStill = 120;
/// Milliseconds after which a picture is drawn in a new size.
constexpr int kResized = 15;

/// OpenGL's bytes r, g, b, a as one of Qt's pixels; little-endian, as all machines with a desktop.
quint32 qtPixel(quint32 rgba) {
    return 0xff000000U | ((rgba & 0xffU) << 16U) | (rgba & 0xff00U) | ((rgba >> 16U) & 0xffU);
}

}  // namespace

VtkWidget::VtkWidget(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    window_->SetMultiSamples(0);
    window_->SetOwnContext(0);
    window_->SetFrameBlitModeToNoBlit();
    window_->SetReadyForRendering(false);
    window_->SetSupportsOpenGL(1);
    window_->SetIsDirect(1);
    window_->AddRenderer(renderer_);
    observer_->SetClientData(this);
    observer_->SetCallback(&VtkWidget::handleWindowEvent);
    window_->AddObserver(vtkCommand::WindowMakeCurrentEvent, observer_);
    window_->AddObserver(vtkCommand::WindowIsCurrentEvent, observer_);
    stillness_.setSingleShot(true);
    stillness_.setInterval(kStill);
    connect(&stillness_, &QTimer::timeout, this, &VtkWidget::smoothen);
    resized_.setSingleShot(true);
    resized_.setInterval(kResized);
    connect(&resized_, &QTimer::timeout, this, qOverload<>(&QWidget::update));
}

VtkWidget::~VtkWidget() {
    if (ready_) {
        context_->makeCurrent(surface_.get());
        window_->Finalize();
        window_->SetReadyForRendering(false);
        context_->doneCurrent();
    }
    window_->RemoveObserver(observer_);
    vtkRendererCollection* renderers = window_->GetRenderers();
    while (vtkRenderer* renderer = renderers->GetFirstRenderer())
        window_->RemoveRenderer(renderer);
}

vtkRenderer* VtkWidget::renderer() const {
    return renderer_;
}

void VtkWidget::add(vtkRenderer* renderer) {
    window_->AddRenderer(renderer);
}

void VtkWidget::markDirty() {
    dirty_ = true;
    update();
}

void VtkWidget::handleWindowEvent(vtkObject*, unsigned long event, void* self, void* data) {
    auto* widget = static_cast<VtkWidget*>(self);
    QOpenGLContext* mine = widget->context_.get();
    if (event == vtkCommand::WindowMakeCurrentEvent) {
        if (mine != nullptr) mine->makeCurrent(widget->surface_.get());
    } else if (event == vtkCommand::WindowIsCurrentEvent) {
        *static_cast<bool*>(data) = mine != nullptr && mine == QOpenGLContext::currentContext();
    }
}

bool VtkWidget::start() {
    if (ready_) return true;
    if (context_) return false;  // tried before
    context_ = std::make_unique<QOpenGLContext>();
    surface_ = std::make_unique<QOffscreenSurface>();
    if (!context_->create()) return false;
    surface_->setFormat(context_->format());
    surface_->create();
    if (!context_->makeCurrent(surface_.get())) return false;
    window_->SetForceMaximumHardwareLineWidth(1);
    window_->SetReadyForRendering(true);
    window_->OpenGLInitContext();
    window_->SetMapped(1);
    const auto* name = context_->functions()->glGetString(GL_RENDERER);
    const QByteArray device(reinterpret_cast<const char*>(name));
    software_ = device.contains("llvmpipe") || device.contains("softpipe") ||
                device.contains("SWR") || device.contains("Software");
    ready_ = true;
    return true;
}

void VtkWidget::draw(bool smooth) {
    if (!start()) return;
    context_->makeCurrent(surface_.get());
    const double ratio = devicePixelRatioF();
    window_->SetSize(std::max(1, static_cast<int>(std::lround(width() * ratio))),
                     std::max(1, static_cast<int>(std::lround(height() * ratio))));
    vtkRendererCollection* renderers = window_->GetRenderers();
    vtkCollectionSimpleIterator at;
    renderers->InitTraversal(at);
    while (vtkRenderer* renderer = renderers->GetNextRenderer(at))
        renderer->SetUseFXAA(smooth);
    // Ghosts are drawn over their own depth.
    window_->GetState()->vtkglDepthFunc(GL_LEQUAL);
    window_->Render();
    readPicture();
    picture_.setDevicePixelRatio(ratio);
    dirty_ = false;
    smooth_ = smooth;
}

void VtkWidget::readPicture() {
    const int* size = window_->GetSize();
    const int columns = size[0];
    const int rows = size[1];
    pixels_.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    vtkOpenGLState* state = window_->GetState();
    state->PushReadFramebufferBinding();
    window_->GetDisplayFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
    window_->GetDisplayFramebuffer()->ActivateReadBuffer(0);
    context_->functions()->glReadPixels(0, 0, columns, rows, GL_RGBA, GL_UNSIGNED_BYTE,
                                        pixels_.data());
    state->PopReadFramebufferBinding();
    if (picture_.size() != QSize(columns, rows)) {
        picture_ = QImage(columns, rows, QImage::Format_RGB32);
    }
    for (int row = 0; row < rows; ++row) {
        const quint32* from = pixels_.data() + std::ptrdiff_t{rows - 1 - row} * columns;
        std::transform(from, from + columns, reinterpret_cast<quint32*>(picture_.scanLine(row)),
                       qtPixel);
    }
}

void VtkWidget::paintEvent(QPaintEvent* event) {
    if (resized_.isActive() && !picture_.isNull()) {
        QPainter(this).drawImage(rect(), picture_);
        return;
    }
    if (dirty_) {
        draw(ready_ && !software_);
        if (!smooth_) stillness_.start();
    }
    QPainter painter(this);
    if (picture_.isNull()) {
        painter.fillRect(event->rect(), palette().window());
        return;
    }
    const double ratio = picture_.devicePixelRatio();
    const QRectF part = event->rect();
    painter.drawImage(part, picture_, QRectF(part.topLeft() * ratio, part.size() * ratio));
}

void VtkWidget::resizeEvent(QResizeEvent*) {
    dirty_ = true;
    if (isVisible() && !resized_.isActive()) resized_.start();
}

void VtkWidget::smoothen() {
    if (dirty_ || smooth_ || !isVisible()) return;
    draw(true);
    update();
}

QImage VtkWidget::picture() {
    draw(true);
    update();
    return picture_;
}

}  // namespace kumite::studio
