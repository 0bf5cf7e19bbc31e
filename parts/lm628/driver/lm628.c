/* SPDX-License-Identifier: Apache-2.0 */
#include "lm628.h"

#include <stddef.h>

/* Ends the function with the error of a step. */
#define LM628_TRY(step)                              \
  do {                                               \
    const lm628_error try_error = (step);            \
    if (try_error != LM628_OK) return try_error;     \
  } while (0)

#define RESET_US 1500u
#define POLL_US 100u /* of lm628_wait_for() */
#define RELATIVE (LM628_POSITION_RELATIVE | LM628_VELOCITY_RELATIVE | LM628_ACCELERATION_RELATIVE)
#define LOADS (LM628_LOAD_POSITION | LM628_LOAD_VELOCITY | LM628_LOAD_ACCELERATION)

const char *lm628_error_text(lm628_error error) {
  switch (error) {
    case LM628_OK: return "done";
    case LM628_ERROR_NULL: return "a pointer or a function of the port is missing";
    case LM628_ERROR_RANGE: return "a value is out of its range";
    case LM628_ERROR_TIMEOUT: return "the part stays busy, or what was waited for did not come";
    case LM628_ERROR_STATUS: return "the status after a reset is none of the data sheet's";
    case LM628_ERROR_COMMAND: return "the part reports a command error";
  }
  return "an unknown error";
}

/* ---- transfers ---- */

static lm628_error usable(const lm628_device *part) {
  return part == NULL || part->port == NULL ? LM628_ERROR_NULL : LM628_OK;
}

static uint8_t status_of(const lm628_device *part) {
  return part->port->read(part->port->context, false);
}

lm628_error lm628_init(lm628_device *part, const lm628_port *port) {
  if (part == NULL) return LM628_ERROR_NULL;
  part->port = NULL;
  part->polls = LM628_POLLS;
  if (port == NULL || port->write == NULL || port->read == NULL || port->wait_us == NULL) {
    return LM628_ERROR_NULL;
  }
  part->port = port;
  return LM628_OK;
}

lm628_error lm628_read_status(lm628_device *part, uint8_t *status) {
  LM628_TRY(usable(part));
  if (status == NULL) return LM628_ERROR_NULL;
  *status = status_of(part);
  return LM628_OK;
}

lm628_error lm628_wait_ready(lm628_device *part) {
  uint32_t left;
  LM628_TRY(usable(part));
  if (part->polls == 0) return LM628_ERROR_RANGE;
  for (left = part->polls; left > 0; --left) {
    if ((status_of(part) & LM628_BUSY) == 0) return LM628_OK;
  }
  return LM628_ERROR_TIMEOUT;
}

lm628_error lm628_write_command(lm628_device *part, uint8_t opcode) {
  LM628_TRY(lm628_wait_ready(part));
  part->port->write(part->port->context, false, opcode);
  return LM628_OK;
}

/* Between the two bytes of a word the part is not busy. */
lm628_error lm628_write_word(lm628_device *part, uint16_t word) {
  LM628_TRY(lm628_wait_ready(part));
  part->port->write(part->port->context, true, (uint8_t)(word >> 8));
  part->port->write(part->port->context, true, (uint8_t)(word & 0xFFu));
  return LM628_OK;
}

lm628_error lm628_write_long(lm628_device *part, int32_t value) {
  const uint32_t bits = (uint32_t)value;
  LM628_TRY(lm628_write_word(part, (uint16_t)(bits >> 16)));
  return lm628_write_word(part, (uint16_t)(bits & 0xFFFFu));
}

lm628_error lm628_read_word(lm628_device *part, uint16_t *word) {
  unsigned high, low;
  if (word == NULL) return LM628_ERROR_NULL;
  LM628_TRY(lm628_wait_ready(part));
  high = part->port->read(part->port->context, true);
  low = part->port->read(part->port->context, true);
  *word = (uint16_t)(high << 8 | low);
  return LM628_OK;
}

static int32_t as_signed(uint32_t bits) {
  return bits <= 0x7FFFFFFFu ? (int32_t)bits : -(int32_t)(~bits) - 1;
}

lm628_error lm628_read_long(lm628_device *part, int32_t *value) {
  uint16_t high, low;
  if (value == NULL) return LM628_ERROR_NULL;
  LM628_TRY(lm628_read_word(part, &high));
  LM628_TRY(lm628_read_word(part, &low));
  *value = as_signed((uint32_t)high << 16 | low);
  return LM628_OK;
}

static lm628_error command_word(lm628_device *part, uint8_t opcode, uint16_t word) {
  LM628_TRY(lm628_write_command(part, opcode));
  return lm628_write_word(part, word);
}

static lm628_error ask_word(lm628_device *part, uint8_t opcode, uint16_t *word) {
  LM628_TRY(usable(part));
  if (word == NULL) return LM628_ERROR_NULL;
  LM628_TRY(lm628_write_command(part, opcode));
  return lm628_read_word(part, word);
}

static lm628_error ask_long(lm628_device *part, uint8_t opcode, int32_t *value) {
  LM628_TRY(usable(part));
  if (value == NULL) return LM628_ERROR_NULL;
  LM628_TRY(lm628_write_command(part, opcode));
  return lm628_read_long(part, value);
}

static lm628_error ask_short(lm628_device *part, uint8_t opcode, int16_t *value) {
  uint16_t word;
  if (value == NULL) return LM628_ERROR_NULL;
  LM628_TRY(ask_word(part, opcode, &word));
  *value = (int16_t)as_signed(word < 0x8000u ? word : 0xFFFF0000u | word);
  return LM628_OK;
}

/* ---- start ---- */

lm628_error lm628_set_output(lm628_device *part, lm628_output output) {
  LM628_TRY(usable(part));
  switch (output) {
    case LM628_OUTPUT_8_BITS: return lm628_write_command(part, LM628_PORT8);
    case LM628_OUTPUT_12_BITS: return lm628_write_command(part, LM628_PORT12);
  }
  return LM628_ERROR_RANGE;
}

lm628_error lm628_reset(lm628_device *part, lm628_output output) {
  uint8_t status;
  LM628_TRY(usable(part));
  if (output != LM628_OUTPUT_8_BITS && output != LM628_OUTPUT_12_BITS) return LM628_ERROR_RANGE;
  if (part->port->strobe_reset != NULL) {
    part->port->strobe_reset(part->port->context);
  } else {
    LM628_TRY(lm628_write_command(part, LM628_RESET));
  }
  part->port->wait_us(part->port->context, RESET_US);
  status = status_of(part);
  if (status != 0x84u && status != 0xC4u) return LM628_ERROR_STATUS;
  LM628_TRY(lm628_set_output(part, output));
  LM628_TRY(lm628_clear(part, LM628_EVENTS));
  LM628_TRY(lm628_wait_ready(part));
  status = status_of(part);
  return status == 0x80u || status == 0xC0u ? LM628_OK : LM628_ERROR_STATUS;
}

/* ---- status ---- */

lm628_error lm628_check(lm628_device *part) {
  LM628_TRY(lm628_wait_ready(part));
  return (status_of(part) & LM628_COMMAND_ERROR) != 0 ? LM628_ERROR_COMMAND : LM628_OK;
}

lm628_error lm628_wait_for(lm628_device *part, uint8_t bits, uint32_t timeout_us, uint8_t *status) {
  uint32_t waited;
  LM628_TRY(usable(part));
  if (bits == 0 || (bits & LM628_BUSY) != 0) return LM628_ERROR_RANGE;
  LM628_TRY(lm628_wait_ready(part)); /* what an RSTI clears is gone when it has been executed */
  for (waited = 0;; waited += POLL_US) {
    const uint8_t now = status_of(part);
    if (status != NULL) *status = now;
    if ((now & bits) != 0) return LM628_OK;
    if (waited >= timeout_us || waited > UINT32_MAX - POLL_US) return LM628_ERROR_TIMEOUT;
    part->port->wait_us(part->port->context, POLL_US);
  }
}

/* ---- commands with a word, or none ---- */

static lm628_error command_mask(lm628_device *part, uint8_t opcode, uint8_t named, uint8_t sent) {
  LM628_TRY(usable(part));
  if ((named & ~LM628_EVENTS) != 0) return LM628_ERROR_RANGE;
  return command_word(part, opcode, sent);
}

lm628_error lm628_mask_interrupts(lm628_device *part, uint8_t enabled) {
  return command_mask(part, LM628_MSKI, enabled, enabled);
}

lm628_error lm628_clear(lm628_device *part, uint8_t bits) {
  return command_mask(part, LM628_RSTI, bits, (uint8_t)(LM628_EVENTS & ~bits));
}

static lm628_error command_threshold(lm628_device *part, uint8_t opcode, uint16_t counts) {
  LM628_TRY(usable(part));
  if (counts > LM628_COEFFICIENT_MAX) return LM628_ERROR_RANGE;
  return command_word(part, opcode, counts);
}

lm628_error lm628_interrupt_on_error(lm628_device *part, uint16_t counts) {
  return command_threshold(part, LM628_LPEI, counts);
}

lm628_error lm628_stop_on_error(lm628_device *part, uint16_t counts) {
  return command_threshold(part, LM628_LPES, counts);
}

static bool is_within(int32_t value, int32_t low, int32_t high) {
  return value >= low && value <= high;
}

static lm628_error command_position(lm628_device *part, uint8_t opcode, int32_t position) {
  LM628_TRY(usable(part));
  if (!is_within(position, LM628_POSITION_MIN, LM628_POSITION_MAX)) return LM628_ERROR_RANGE;
  LM628_TRY(lm628_write_command(part, opcode));
  return lm628_write_long(part, position);
}

lm628_error lm628_set_breakpoint(lm628_device *part, int32_t position) {
  return command_position(part, LM628_SBPA, position);
}

lm628_error lm628_set_breakpoint_relative(lm628_device *part, int32_t distance) {
  return command_position(part, LM628_SBPR, distance);
}

lm628_error lm628_capture_index(lm628_device *part) { return lm628_write_command(part, LM628_SIP); }
lm628_error lm628_define_home(lm628_device *part) { return lm628_write_command(part, LM628_DFH); }
lm628_error lm628_update_filter(lm628_device *part) { return lm628_write_command(part, LM628_UDF); }
lm628_error lm628_start(lm628_device *part) { return lm628_write_command(part, LM628_STT); }

/* ---- filter and trajectory ---- */

static bool fits(const lm628_filter *f, unsigned load, uint16_t value) {
  return (f->loads & load) == 0 || value <= LM628_COEFFICIENT_MAX;
}

lm628_error lm628_load_filter(lm628_device *part, const lm628_filter *f) {
  LM628_TRY(usable(part));
  if (f == NULL) return LM628_ERROR_NULL;
  if ((f->loads & ~0xFu) != 0 || f->interval < 1 || f->interval > 256 ||
      !fits(f, LM628_KP, f->kp) || !fits(f, LM628_KI, f->ki) || !fits(f, LM628_KD, f->kd) ||
      !fits(f, LM628_IL, f->il)) {
    return LM628_ERROR_RANGE;
  }
  LM628_TRY(command_word(part, LM628_LFIL, (uint16_t)((f->interval - 1u) << 8 | f->loads)));
  if ((f->loads & LM628_KP) != 0) LM628_TRY(lm628_write_word(part, f->kp));
  if ((f->loads & LM628_KI) != 0) LM628_TRY(lm628_write_word(part, f->ki));
  if ((f->loads & LM628_KD) != 0) LM628_TRY(lm628_write_word(part, f->kd));
  if ((f->loads & LM628_IL) != 0) LM628_TRY(lm628_write_word(part, f->il));
  return LM628_OK;
}

/* A rate that is not loaded may have any value. */
static bool is_rate(unsigned control, unsigned load, unsigned relative, int32_t value) {
  const int32_t low = (control & relative) != 0 ? -LM628_RATE_MAX : 0;
  return (control & load) == 0 || is_within(value, low, LM628_RATE_MAX);
}

lm628_error lm628_load_trajectory(lm628_device *part, const lm628_trajectory *t) {
  const unsigned known = LOADS | RELATIVE | LM628_VELOCITY_MODE | LM628_FORWARD;
  LM628_TRY(usable(part));
  if (t == NULL) return LM628_ERROR_NULL;
  if ((t->control & ~known) != 0 ||
      !is_rate(t->control, LM628_LOAD_ACCELERATION, LM628_ACCELERATION_RELATIVE,
               t->acceleration) ||
      !is_rate(t->control, LM628_LOAD_VELOCITY, LM628_VELOCITY_RELATIVE, t->velocity) ||
      ((t->control & LM628_LOAD_POSITION) != 0 &&
       !is_within(t->position, LM628_POSITION_MIN, LM628_POSITION_MAX))) {
    return LM628_ERROR_RANGE;
  }
  LM628_TRY(command_word(part, LM628_LTRJ, t->control));
  if ((t->control & LM628_LOAD_ACCELERATION) != 0) {
    LM628_TRY(lm628_write_long(part, t->acceleration));
  }
  if ((t->control & LM628_LOAD_VELOCITY) != 0) LM628_TRY(lm628_write_long(part, t->velocity));
  if ((t->control & LM628_LOAD_POSITION) != 0) LM628_TRY(lm628_write_long(part, t->position));
  return LM628_OK;
}

lm628_error lm628_stop(lm628_device *part, lm628_stop_kind kind) {
  LM628_TRY(usable(part));
  if (kind != LM628_STOP_MOTOR_OFF && kind != LM628_STOP_ABRUPTLY && kind != LM628_STOP_SMOOTHLY) {
    return LM628_ERROR_RANGE;
  }
  LM628_TRY(command_word(part, LM628_LTRJ, (uint16_t)kind));
  return lm628_start(part);
}

/* ---- what the part reports ---- */

lm628_error lm628_read_position(lm628_device *part, int32_t *counts) {
  return ask_long(part, LM628_RDRP, counts);
}

lm628_error lm628_read_desired_position(lm628_device *part, int32_t *counts) {
  return ask_long(part, LM628_RDDP, counts);
}

lm628_error lm628_read_index(lm628_device *part, int32_t *counts) {
  return ask_long(part, LM628_RDIP, counts);
}

lm628_error lm628_read_desired_velocity(lm628_device *part, int32_t *velocity) {
  return ask_long(part, LM628_RDDV, velocity);
}

lm628_error lm628_read_velocity(lm628_device *part, int16_t *counts_per_sample) {
  return ask_short(part, LM628_RDRV, counts_per_sample);
}

lm628_error lm628_read_signals(lm628_device *part, uint16_t *signals) {
  return ask_word(part, LM628_RDSIGS, signals);
}

lm628_error lm628_read_sum(lm628_device *part, int16_t *sum) {
  return ask_short(part, LM628_RDSUM, sum);
}
