// SPDX-License-Identifier: MIT
// A VTK render window without X, on Mesa's surfaceless EGL platform. (Debian's VTK 9.1 supports GLX only.)
#pragma once

// clang-format off
#include <GL/glew.h>  // before all other GL headers
#include <EGL/egl.h>
// clang-format on
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkObjectFactory.h>

namespace bake {

/// Throws std::runtime_error in New() if there is no such platform.
class HeadlessWindow : public vtkGenericOpenGLRenderWindow {  // NOLINT(cppcoreguidelines-virtual-class-destructor): VTK deletes it
 public:
  vtkTypeMacro(HeadlessWindow, vtkGenericOpenGLRenderWindow);
  static HeadlessWindow* New() { VTK_STANDARD_NEW_BODY(HeadlessWindow); }
  void MakeCurrent() override;
  bool IsCurrent() override;
  int SupportsOpenGL() override { return 1; }
  vtkTypeBool IsDirect() override { return 1; }
  void OpenGLInitContext() override;

 protected:
  HeadlessWindow();
  ~HeadlessWindow() override;

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace bake
