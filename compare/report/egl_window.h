#pragma once
#include <memory>
#include <string>

class vtkRenderer;

namespace tw {

/// Pictures without a display: an EGL surfaceless context (Mesa's software renderer where there is no graphics card)
/// under VTK's generic window. Debian's VTK is built for X11 only and aborts without a display.
class EglWindow {
public:
    /// Throws RunError with the reason when the machine has no such context.
    EglWindow(int width, int height);
    ~EglWindow();
    EglWindow(const EglWindow&) = delete;
    EglWindow& operator=(const EglWindow&) = delete;
    /// PNG bytes of what the renderer shows.
    std::string png(vtkRenderer* renderer);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace tw
