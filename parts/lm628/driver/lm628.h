/* SPDX-License-Identifier: Apache-2.0
 *
 * C99 driver of the LM628 and LM629 (data sheet SNVS781C, AN-693). Freestanding: no allocation, no
 * globals, no library. Every wait is bounded. The part is reached through an lm628_port: that of
 * lm628_mmio.h, of lm628_gpio.h, or your own.
 *
 * Units: positions in counts (quadrature transitions), velocities in 2^-16 count/sample,
 * accelerations in 2^-16 count/sample^2; a sample is 2048 clocks, 256 us at 8 MHz.
 *
 * All functions return an lm628_error. After an error nothing more was written; a transfer that a
 * timeout cuts short is dropped by the next command, which then sets LM628_COMMAND_ERROR.
 */
#ifndef LM628_H
#define LM628_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum lm628_error {
  LM628_OK = 0,
  LM628_ERROR_NULL,    /* a pointer or a port's function is missing, or lm628_init() failed */
  LM628_ERROR_RANGE,   /* a value is out of its range; nothing was written */
  LM628_ERROR_TIMEOUT, /* the part stayed busy, or what was waited for did not come */
  LM628_ERROR_STATUS,  /* after a reset the status is not one of the data sheet's: no part there? */
  LM628_ERROR_COMMAND  /* the part reports a command error */
} lm628_error;

/* A short text without a newline, also for values that are no error of this list. */
const char *lm628_error_text(lm628_error error);

/* One access each, by the data sheet's times, whether the part is busy or not. `ps` is the level of
 * the pin: false is command (write) and status (read), true is data. */
typedef struct lm628_port {
  void (*write)(void *context, bool ps, uint8_t byte);
  uint8_t (*read)(void *context, bool ps);
  void (*strobe_reset)(void *context); /* RST low for 8 clocks; NULL: not wired */
  void (*wait_us)(void *context, uint32_t us); /* at least so long; asked for at most 1500 */
  void *context;
} lm628_port;

/* The part is busy for at most 100 us after a command or word, and by the data sheet's times a read
 * takes at least 0.3 us: so many status reads are more than 1 ms. */
#define LM628_POLLS 4096u

typedef struct lm628_device {
  const lm628_port *port; /* of the caller, who keeps it */
  uint32_t polls;         /* status reads until LM628_ERROR_TIMEOUT, at least 1 */
} lm628_device;

/* ---- values ---- */

#define LM628_POSITION_MIN (-1073741824)
#define LM628_POSITION_MAX 1073741823
#define LM628_RATE_MAX 1073741823 /* of velocity and acceleration */
#define LM628_COEFFICIENT_MAX 32767

enum lm628_opcode {
  LM628_RESET = 0x00, LM628_STT = 0x01, LM628_DFH = 0x02, LM628_SIP = 0x03,
  LM628_UDF = 0x04, LM628_PORT8 = 0x05, LM628_PORT12 = 0x06, LM628_RDDV = 0x07,
  LM628_RDDP = 0x08, LM628_RDIP = 0x09, LM628_RDRP = 0x0A, LM628_RDRV = 0x0B,
  LM628_RDSIGS = 0x0C, LM628_RDSUM = 0x0D, LM628_LPES = 0x1A, LM628_LPEI = 0x1B,
  LM628_MSKI = 0x1C, LM628_RSTI = 0x1D, LM628_LFIL = 0x1E, LM628_LTRJ = 0x1F,
  LM628_SBPA = 0x20, LM628_SBPR = 0x21
};

/* Status byte. Bits 1 to 6 hold until they are cleared; they are also those of the masks. */
enum lm628_status_bit {
  LM628_BUSY = 0x01,
  LM628_COMMAND_ERROR = 0x02,
  LM628_TRAJECTORY_COMPLETE = 0x04,
  LM628_INDEX = 0x08,
  LM628_WRAPAROUND = 0x10,
  LM628_POSITION_ERROR = 0x20,
  LM628_BREAKPOINT = 0x40,
  LM628_MOTOR_OFF = 0x80,
  LM628_EVENTS = 0x7E /* all that can interrupt */
};

/* Signals register: bits 1 to 7 as in the status byte, and these. */
enum lm628_signal_bit {
  LM628_ACQUIRE_INDEX = 0x0001,
  LM628_EIGHT_BITS = 0x0100,
  LM628_OFF_ON_ERROR = 0x0200,
  LM628_ON_TARGET = 0x0400,
  LM628_IN_VELOCITY_MODE = 0x0800,
  LM628_IS_FORWARD = 0x1000,
  LM628_FILTER_UPDATED = 0x2000,
  LM628_ACCELERATION_LOADED = 0x4000,
  LM628_HOST_INTERRUPT = 0x8000
};

typedef enum lm628_output { LM628_OUTPUT_8_BITS = 8, LM628_OUTPUT_12_BITS = 12 } lm628_output;

/* lm628_filter.loads */
enum { LM628_KP = 0x8, LM628_KI = 0x4, LM628_KD = 0x2, LM628_IL = 0x1 };

typedef struct lm628_filter {
  uint16_t loads;          /* which of the four are loaded; the others stay as they are */
  uint16_t kp, ki, kd, il; /* 0 to 32767 */
  uint16_t interval;       /* of the derivative term, 1 to 256 samples; always loaded */
} lm628_filter;

/* lm628_trajectory.control */
enum {
  LM628_POSITION_RELATIVE = 0x0001, /* to the target */
  LM628_LOAD_POSITION = 0x0002,
  LM628_VELOCITY_RELATIVE = 0x0004, /* to what was loaded before */
  LM628_LOAD_VELOCITY = 0x0008,
  LM628_ACCELERATION_RELATIVE = 0x0010,
  LM628_LOAD_ACCELERATION = 0x0020,
  LM628_VELOCITY_MODE = 0x0800,
  LM628_FORWARD = 0x1000 /* in velocity mode; else backward */
};

typedef enum lm628_stop_kind {
  LM628_STOP_MOTOR_OFF = 0x0100,
  LM628_STOP_ABRUPTLY = 0x0200,
  LM628_STOP_SMOOTHLY = 0x0400 /* by the acceleration in use */
} lm628_stop_kind;

typedef struct lm628_trajectory {
  uint16_t control;     /* what is loaded, and how; a stop is lm628_stop() */
  int32_t acceleration; /* 0 to LM628_RATE_MAX and, says the data sheet, not above the velocity */
  int32_t velocity;     /* 0 to LM628_RATE_MAX; a relative one may be negative, so may the other */
  int32_t position;     /* LM628_POSITION_MIN to LM628_POSITION_MAX */
} lm628_trajectory;

/* ---- start ---- */

/* Fills in `part`, which accesses nothing. `port` stays in use. */
lm628_error lm628_init(lm628_device *part, const lm628_port *port);

/* AN-693, "Initialization": RST, or where it is not wired the command RESET; 1.5 ms; the status
 * must be 84h or C4h; the output's width; RSTI 0000h; the status must be 80h or C0h. The motor is
 * off, coefficients are 0. AN-693 repeats a reset that ends with LM628_ERROR_STATUS. */
lm628_error lm628_reset(lm628_device *part, lm628_output output);
lm628_error lm628_set_output(lm628_device *part, lm628_output output); /* PORT8, PORT12 */

/* ---- status ---- */

/* RDSTAT: at any time, between the bytes of a word too. */
lm628_error lm628_read_status(lm628_device *part, uint8_t *status);

/* Until the last command or word has been executed. */
lm628_error lm628_wait_ready(lm628_device *part);

/* The same; then LM628_ERROR_COMMAND if the bit is set, be it from before. */
lm628_error lm628_check(lm628_device *part);

/* Until one of these status bits is set, for at least `timeout_us`. `status`, which may be NULL, is
 * the last one read. */
lm628_error lm628_wait_for(lm628_device *part, uint8_t bits, uint32_t timeout_us, uint8_t *status);

/* ---- interrupts ---- */

/* MSKI: of LM628_EVENTS those that raise HI. */
lm628_error lm628_mask_interrupts(lm628_device *part, uint8_t enabled);
/* RSTI: clears these of LM628_EVENTS, and HI. */
lm628_error lm628_clear(lm628_device *part, uint8_t bits);
/* LPEI, LPES: position error, 0 to 32767, that sets LM628_POSITION_ERROR; LPES: and stops. */
lm628_error lm628_interrupt_on_error(lm628_device *part, uint16_t counts);
lm628_error lm628_stop_on_error(lm628_device *part, uint16_t counts);
/* SBPA, and SBPR relative to the target. */
lm628_error lm628_set_breakpoint(lm628_device *part, int32_t position);
lm628_error lm628_set_breakpoint_relative(lm628_device *part, int32_t distance);
lm628_error lm628_capture_index(lm628_device *part); /* SIP: the next index pulse */
lm628_error lm628_define_home(lm628_device *part);   /* DFH: here is 0 */

/* ---- filter and trajectory ---- */

/* LFIL and LTRJ load buffers, which UDF and STT put to use. */
lm628_error lm628_load_filter(lm628_device *part, const lm628_filter *filter);
lm628_error lm628_update_filter(lm628_device *part);
lm628_error lm628_load_trajectory(lm628_device *part, const lm628_trajectory *trajectory);

/* STT. The part refuses a new acceleration in motion: see lm628_check(). */
lm628_error lm628_start(lm628_device *part);
/* LTRJ, STT. */
lm628_error lm628_stop(lm628_device *part, lm628_stop_kind kind);

/* ---- what the part reports ---- */

lm628_error lm628_read_position(lm628_device *part, int32_t *counts);            /* RDRP */
lm628_error lm628_read_desired_position(lm628_device *part, int32_t *counts);    /* RDDP */
lm628_error lm628_read_index(lm628_device *part, int32_t *counts);               /* RDIP */
lm628_error lm628_read_desired_velocity(lm628_device *part, int32_t *velocity);  /* RDDV */
lm628_error lm628_read_velocity(lm628_device *part, int16_t *counts_per_sample); /* RDRV */
lm628_error lm628_read_signals(lm628_device *part, uint16_t *signals);           /* RDSIGS */
lm628_error lm628_read_sum(lm628_device *part, int16_t *sum); /* RDSUM [256 count samples] */

/* ---- single transfers: each waits until the part takes it ---- */

lm628_error lm628_write_command(lm628_device *part, uint8_t opcode);
lm628_error lm628_write_word(lm628_device *part, uint16_t word);
lm628_error lm628_write_long(lm628_device *part, int32_t value);
lm628_error lm628_read_word(lm628_device *part, uint16_t *word);
lm628_error lm628_read_long(lm628_device *part, int32_t *value);

#ifdef __cplusplus
}
#endif

#endif
