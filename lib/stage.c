#include "stage.h"

#include <unistd.h>

static enum tcs_status
let_appear(struct stage *stage, struct tcs_fault *fault)
{
	bool is_pair = stage->beside.file != NULL;
	enum tcs_status status = TCS_OK;

	if (is_pair)
		status = output_commit(&stage->beside, fault);
	if (status)
		return status;
	status = output_commit(&stage->out, fault);
	if (status && is_pair)
		unlink(stage->beside.name);
	return status;
}

int
stage_run(const struct command *command, stage_work *work, void *context)
{
	struct stage stage = {.command = command};
	const char *program = command->program->name;
	struct tcs_fault fault;
	enum tcs_status status = work(context, &stage, &fault);
	int code = EXIT_DONE;

	if (!status && command->stats)
		status = report_write(
			&stage.report, program, command->stats, &fault);
	if (!status)
		status = let_appear(&stage, &fault);
	if (status)
		code = program_fail(command, &fault);
	if (!command->quiet)
		report_print(&stage.report, program, stderr);
	output_discard(&stage.out);
	output_discard(&stage.beside);
	report_release(&stage.report);
	return code;
}
