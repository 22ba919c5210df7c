// The application's state machine: what the screens show, what taps and commands do. One per run.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "app/application/align_session.h"
#include "app/application/box_session.h"
#include "app/application/check_evidence.h"
#include "app/application/evidence_desk.h"
#include "app/application/find_session.h"
#include "app/application/find_worker.h"
#include "app/application/job_session.h"
#include "app/application/job_thread.h"
#include "app/application/picture.h"
#include "app/application/pose_table.h"
#include "app/application/steady_readings.h"
#include "app/application/view_control.h"
#include "app/common/length_text.h"
#include "app/evidence/inspection_record.h"
#include "app/evidence/result_rows.h"
#include "app/runner/command_queue.h"
#include "app/runner/feed.h"
#include "app/ui/gestures.h"
#include "app/ui/input_queue.h"
#include "app/ui/key_press.h"
#include "app/ui/panels.h"
#include "vision/core/distance_volume.h"
#include "vision/core/result.h"
#include "vision/inspector.h"

struct ImGuiContext;

namespace spool {

// What one run is made of. `feed` is made anew for a replay.
struct ApplicationInputs {
  std::shared_ptr<const PreparedDesign> design;
  Camera camera;
  NoiseModel noise;
  std::string source_text;  // as on the command line
  std::string source_description;
  bool is_recording = false;
  std::function<Result<std::unique_ptr<Feed>>()> open_feed;
  std::filesystem::path out;  // pictures and evidence go here
  std::string source_remark;  // what the fitter should know of it at once; may be empty
  LengthStyle lengths = LengthStyle::kMillimetre;  // on the screen and in reports of checks
  double dots_per_inch = 160;
  int width = 1280, height = 800;  // px
  // Of every frame, for poses(): memory that grows with the run. Else of the last seconds only.
  bool keep_poses = true;
  std::unique_ptr<JobSession> job;  // of this design; null: there is none
  bool wait_for_jobs = false;  // each frame waits for its jobs: the same pictures on any machine
  // A graphics card draws: it colours every pixel of a frame. Not said: the driver is asked.
  std::optional<bool> has_graphics_card;
};

// All functions on the main (GL) thread, a GLES 3 context current from create() to destruction.
class Application {
 public:
  [[nodiscard]] static Result<std::unique_ptr<Application>> create(ApplicationInputs inputs);
  Application(const Application&) = delete;
  Application& operator=(const Application&) = delete;
  ~Application();

  // Takes what sensor and vision have. The time that passed in a recording (s) when there is a new
  // frame.
  [[nodiscard]] std::optional<double> advance();
  // One frame of the screen at `now_s`: input in, picture out into picture().target(). `keys` are
  // of a real keyboard; they count where a text is asked for.
  [[nodiscard]] Status frame(double now_s, const std::vector<ui::TouchEvent>& events,
                             const std::vector<ui::KeyPress>& keys = {});
  [[nodiscard]] Status resize(int width, int height);

  // Nothing is on its way: no input, no job, no answer awaited.
  [[nodiscard]] bool is_idle() const;
  [[nodiscard]] bool source_has_ended() const { return ended_; }
  // Lets a held recording go on: nobody will tap any more.
  void give_up_picks();
  // The last tracked state's inspection into `out`, the last screen, the jobs' errors. Ends the
  // run.
  [[nodiscard]] Status finish();

  [[nodiscard]] const Picture& picture() const { return *picture_; }
  [[nodiscard]] const PoseTable& poses() const { return poses_; }
  // Screen, targets and views as one line of JSON; empty while it is what the last call gave.
  [[nodiscard]] std::string changed_targets();
  // The sensor's failure, once: the run cannot go on usefully.
  [[nodiscard]] const std::optional<Error>& failure() const { return failure_; }

 private:
  struct Checked {
    VisionStatePtr state;
    Result<Inspection> inspection;
    Result<evidence::ScanSnapshot> scan;  // without its cloud
    Pose T_design_scan = Pose::Identity();
    AlignMethod posed_by = AlignMethod::kPose;
    bool final = false;
    int step_part = -1;       // of the job, when it was asked for
    std::uint64_t asked = 0;  // of a job's checks: which
    evidence::OneFrame frame = {};
  };
  using CheckEvidencePtr = std::shared_ptr<const CheckEvidence>;
  struct CaptureAnswer {
    CheckEvidencePtr check;
    Result<Captured> captured;
  };

  // Of one check, of one state.
  struct Results {
    VisionStatePtr state;
    std::shared_ptr<const evidence::InspectionRecord> record;
    std::vector<evidence::ResultRow> rows;  // of the record's inspection
    std::vector<ui::ResultLine> lines;      // one a row
    ui::ResultDetail readout;               // what decides
  };

  explicit Application(ApplicationInputs inputs);
  // application.cpp
  void take_notes();
  [[nodiscard]] const VisionStatePtr& shown() const {
    if (find_.shown()) return find_.shown();
    if (screen_ == ui::Screen::kAlign) return box_.seen_through(held_ ? held_ : seen_);
    if (held_) return held_;
    if (screen_ == ui::Screen::kResults && results_) return results_->state;
    return frozen_ ? frozen_ : seen_;
  }
  // What is shown is what the sensor sees now, or did last.
  [[nodiscard]] bool is_live() const {
    return !find_.shown() && !held_ && !frozen_ && screen_ != ui::Screen::kResults;
  }
  void route(const std::vector<ui::TouchEvent>& events);
  [[nodiscard]] std::vector<ScenePicture> scenes();
  void follow_readings();
  void set_look(ScenePicture& scene, const VisionState& state) const;
  [[nodiscard]] Status update_still();
  // application_commands.cpp
  void handle(const ui::Command& command);
  void handle(const ui::Gesture& gesture);
  void tap(const ui::Gesture& gesture);
  void pick(const ui::Gesture& gesture, double slop_px);
  void start_align();
  void finish_align();
  void ask_for_alignment(VisionStatePtr on, const Pose& T_design_camera, AlignMethod method);
  void leave_align();
  [[nodiscard]] std::vector<double> landmark_evidence(std::span<const PointPair> pairs) const;
  void hold_picture();
  void release_picture();
  void save_screen(const std::string& file);
  void save_last();
  void take_saved();
  void notice(std::string text);
  void fail(const Error& error);
  // application_check.cpp
  void start_check(bool final);
  void take_checks();
  // application_results.cpp
  void keep_results(VisionStatePtr state, std::shared_ptr<const evidence::InspectionRecord> record,
                    int step_part);
  void open_results(int row, bool alone);
  [[nodiscard]] bool open_results_of(int part);
  void leave_results();
  void drop_results();
  void watch_results();
  [[nodiscard]] bool shows_readout() const;
  [[nodiscard]] std::string age_of_results() const;
  void fill_results(ui::ScreenState& out) const;
  [[nodiscard]] std::array<int, 2> lit_parts() const;
  [[nodiscard]] render::View results_view() const;
  // application_box.cpp
  void press_box();
  void tap_box(const ui::Gesture& gesture, double slop_px);
  [[nodiscard]] bool fill_box(ui::ScreenState& out) const;
  [[nodiscard]] std::string box_in_words() const;
  // application_distances.cpp
  void start_distances();
  void take_distances();
  // application_find.cpp
  [[nodiscard]] bool can_find() const;
  void start_find();
  void stop_find();
  void take_find();
  void look_for_moved_spool();
  void take_moved_spool();
  void show_next_choice();
  void accept_choice();
  void align_as_found(const VisionState& found);
  void refuse_found();
  void lose_sensor();
  [[nodiscard]] bool fill_find(ui::ScreenState& out) const;
  void fill_choose(ui::ScreenState& out) const;
  // application_job.cpp
  void show_step();
  void leave_out_absent(std::vector<double>& likelihood) const;
  void accept_step();
  void take_accepted();
  void fill_job(ui::ScreenState& out) const;
  // application_evidence.cpp
  void ask_for_name();
  void handle_evidence(const ui::Command& command);
  void open_capture(std::int64_t number);
  void leave_evidence();
  void take_desk();
  void capture(const CheckEvidencePtr& check);
  void capture_again();
  void take_captures();
  [[nodiscard]] std::string uncaptured_in_words() const;
  [[nodiscard]] std::string disk_in_words() const;
  void fill_evidence(ui::ScreenState& out) const;
  // application_ncr.cpp
  void open_form();
  void start_typing(std::optional<int> field);
  void end_typing(TypingSession::End end);
  void keep_draft();
  void write_form();
  void take_form(OpenedForm opened);
  void take_written(const WrittenForm& written);
  void fill_form(ui::ScreenState& out) const;
  // application_screen.cpp
  [[nodiscard]] ui::ScreenState screen_state() const;
  void fill_align(ui::ScreenState& out) const;
  void fill_work(ui::ScreenState& out) const;
  [[nodiscard]] bool has_pictures() const;
  [[nodiscard]] bool shows_pose() const;
  [[nodiscard]] bool shows_still() const;
  [[nodiscard]] render::View camera_view(const VisionState* state, int width, int height) const;
  [[nodiscard]] std::vector<render::Marker> design_markers() const;
  [[nodiscard]] std::vector<render::Marker> scan_markers() const;

  ApplicationInputs in_;
  std::unique_ptr<ImGuiContext, void (*)(ImGuiContext*)> imgui_;
  ui::Theme theme_;
  std::unique_ptr<Picture> picture_;
  std::unique_ptr<Feed> feed_;
  PoseTable poses_;
  LandmarkProposal landmarks_;
  AlignSession picks_;
  FindSession find_;
  BoxSession box_;

  // What is shown.
  VisionStatePtr state_;         // the newest
  VisionStatePtr seen_;          // the newest of a picture that did not go out
  VisionStatePtr held_;          // picks are being made on this one
  VisionStatePtr frozen_;        // looked at, while the live ones go on underneath
  VisionStatePtr last_tracked_;  // the newest with a believed pose
  VisionStatePtr moved_search_;  // the picture that a moved spool is looked for in; none: it is not
  double no_search_before_s_ = 0;
  VisionStatePtr still_of_;  // the last good view that the picture holds; none: none
  ui::Screen screen_ = ui::Screen::kAlign;
  bool aligned_ = false;
  std::uint64_t alignments_asked_ = 0;
  bool awaiting_alignment_ = false;
  AlignMethod asked_by_ = AlignMethod::kThreePoint;    // the pose that is awaited
  AlignMethod aligned_by_ = AlignMethod::kThreePoint;  // the pose that is believed
  bool unplugged_ = false, replugged_ = false, ended_ = false;
  SensorNote trouble_;  // the sensor's, as last told: kNone until then
  std::optional<Error> failure_;
  enum class ViewMode { kBoth, kScan, kDrawing, kSeen };  // kSeen: how well the drawing is known
  ViewMode view_mode_ = ViewMode::kBoth;
  int lit_part_ = -1;
  bool list_open_ = false, menu_open_ = false;
  std::string notice_;
  double notice_until_s_ = 0;
  double now_s_ = 0;

  // Input.
  ui::Layout layout_;
  ui::InputQueue input_;
  ui::Pointer pointer_;
  ui::GestureRecogniser gestures_;
  std::set<int> panel_fingers_;  // came down on a panel; no gesture comes of them
  ui::TargetList targets_;
  ViewControl design_eye_, scan_eye_, work_eye_;
  bool detached_ = false;
  std::string last_targets_;
  SteadyReadings steady_;  // of the picture shown
  VisionStatePtr steady_of_;

  // The job's.
  std::vector<bool> on_table_;  // one a part: it stands, or is the present step's
  std::optional<render::Marker> ghost_marker_;
  CommandQueue<Result<JournalView>> accepted_;  // what the journal holds after an acceptance
  int accepts_open_ = 0;

  // Captures: what is not on the disk yet stays here, whatever fails.
  std::uint64_t checks_asked_ = 0;
  std::vector<CheckEvidencePtr> uncaptured_;  // that could not be written, or whose checker nobody
                                              // named yet
  std::optional<Error> capture_error_;        // why, as last told; none: for want of a name
  int captures_open_ = 0;
  CommandQueue<CaptureAnswer> captured_;
  EvidenceDesk desk_;
  CommandQueue<DeskAnswer> desk_answers_;
  int desk_open_ = 0;  // answers awaited

  // The last check's.
  std::optional<Results> results_;
  bool picture_changed_ = false;  // since it was checked
  int open_row_ = -1;
  bool row_alone_ = false;  // opened by a tap on its part: Back goes to the work
  ViewControl results_eye_;

  // Evidence.
  int shots_ = 0, checks_ = 0, checks_open_ = 0;
  std::optional<std::string> pending_screen_;  // file to save after the next draw
  bool finishing_ = false;
  std::optional<std::pair<ui::StatusMark, std::string>> last_check_;
  CommandQueue<Checked> checked_;
  CommandQueue<Error> write_errors_;
  std::optional<Error> first_write_error_;
  CommandQueue<DistanceVolume> distances_;
  std::stop_source stop_distances_;
  CommandQueue<Result<std::string>> saved_;  // what was said of each saving
  int saves_open_ = 0;
  JobThread saving_;  // a thread of its own: a check need not wait for so many files
  JobThread jobs_;    // last but one: its jobs use what stands above
  FindWorker finder_;
};

}  // namespace spool
